#include "fluid/collide_row.hpp"

namespace tt {

TT_CLONES void collide_row(LinearEquilibrium, const RowOfSites& row) {
    collide_row_with<LinearEquilibrium>(row);
}
TT_CLONES void collide_row(IncompressibleEquilibrium, const RowOfSites& row) {
    collide_row_with<IncompressibleEquilibrium>(row);
}
TT_CLONES void collide_row(FullEquilibrium, const RowOfSites& row) {
    collide_row_with<FullEquilibrium>(row);
}

}  // namespace tt
