#include "fluid/collide_row.hpp"

namespace tt {

// Called from other files: one line per instance.
TT_CLONES void collide_row(LinearEquilibrium, const RowOfSites<double>& row) {
    collide_row_with<LinearEquilibrium>(row);
}
TT_CLONES void collide_row(LinearEquilibrium, const RowOfSites<float>& row) {
    collide_row_with<LinearEquilibrium>(row);
}
TT_CLONES void collide_row(IncompressibleEquilibrium, const RowOfSites<double>& row) {
    collide_row_with<IncompressibleEquilibrium>(row);
}
TT_CLONES void collide_row(IncompressibleEquilibrium, const RowOfSites<float>& row) {
    collide_row_with<IncompressibleEquilibrium>(row);
}
TT_CLONES void collide_row(FullEquilibrium, const RowOfSites<double>& row) {
    collide_row_with<FullEquilibrium>(row);
}
TT_CLONES void collide_row(FullEquilibrium, const RowOfSites<float>& row) {
    collide_row_with<FullEquilibrium>(row);
}

}  // namespace tt
