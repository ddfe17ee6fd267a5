#include "io/vtk.hpp"

#include <fmt/format.h>

#include "io/file.hpp"

namespace tt {
namespace {

/// Builds the XML head and, behind it, the bytes that its offsets point to. An offset counts from
/// the byte after the underscore of <AppendedData>; every block is its size as UInt64, then its
/// bytes.
class AppendedFile {
public:
    explicit AppendedFile(std::string_view kind) {
        head_ = fmt::format(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n",
            kind);
    }

    void add(std::string_view xml) { head_ += xml; }

    void add(const VtkArray& array) {
        head_ += fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
            "offset=\"{}\"/>\n",
            array.type, array.name, array.components, data_.size());
        const std::uint64_t size = array.bytes.size();
        char header[sizeof size];
        std::memcpy(header, &size, sizeof size);
        data_.append(header, sizeof size);
        data_ += array.bytes;
    }

    void add(std::string_view section, const std::vector<VtkArray>& arrays) {
        head_ += fmt::format("<{}>\n", section);
        for (const VtkArray& array : arrays) add(array);
        head_ += fmt::format("</{}>\n", section);
    }

    void save(const std::filesystem::path& path) const {
        replace_file(path,
                     head_ + "<AppendedData encoding=\"raw\">\n_" + data_ +
                         "\n</AppendedData>\n</VTKFile>\n",
                     Durability::process);
    }

private:
    std::string head_, data_;
};

}  // namespace

void write_vti(const std::filesystem::path& path, int nx, int ny, Vec2 origin, double spacing,
               const std::vector<VtkArray>& point_data) {
    AppendedFile file("ImageData");
    const std::string extent = fmt::format("0 {} 0 {} 0 0", nx - 1, ny - 1);
    file.add(
        fmt::format("<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} 0\" Spacing=\"{3} {3} "
                    "{3}\">\n<Piece Extent=\"{0}\">\n",
                    extent, origin.x, origin.y, spacing));
    file.add("PointData", point_data);
    file.add("</Piece>\n</ImageData>\n");
    file.save(path);
}

void write_vtp(const std::filesystem::path& path, std::span<const Vec2> points,
               const VtkElements& lines, const VtkElements& polygons,
               const std::vector<VtkArray>& point_data, const std::vector<VtkArray>& element_data) {
    std::vector<double> coordinates;
    for (const Vec2 p : points) coordinates.insert(coordinates.end(), {p.x, p.y, 0.0});
    AppendedFile file("PolyData");
    file.add(
        fmt::format("<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" "
                    "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                    points.size(), lines.offsets.size(), polygons.offsets.size()));
    file.add("PointData", point_data);
    file.add("CellData", element_data);
    file.add("Points", {vtk_array("Points", 3, coordinates)});
    file.add("Lines", {vtk_array("connectivity", 1, lines.connectivity),
                       vtk_array("offsets", 1, lines.offsets)});
    file.add("Polys", {vtk_array("connectivity", 1, polygons.connectivity),
                       vtk_array("offsets", 1, polygons.offsets)});
    file.add("</Piece>\n</PolyData>\n");
    file.save(path);
}

void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
    for (const PvdEntry& entry : entries)
        text += fmt::format("<DataSet timestep=\"{:.9g}\" part=\"0\" file=\"{}\"/>\n", entry.time,
                            entry.file);
    replace_file(path, text + "</Collection>\n</VTKFile>\n", Durability::process);
}

}  // namespace tt
