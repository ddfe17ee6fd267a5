#include "io/hdf5_input.hpp"

#include <utility>

#include <fmt/format.h>
#include <hdf5.h>

#include "base/error.hpp"

namespace tt {
namespace {

/// Closes an HDF5 identifier with the function that belongs to its kind.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
        if (id < 0) throw IoError(what + " cannot be read");
    }
    ~Handle() { close_(id_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Exists without printing HDF5's own error stack: every link on the way must be asked for.
bool path_exists(hid_t file, const std::string& object) {
    if (object == "/") return true;
    for (std::size_t end = 0; end != std::string::npos;) {
        end = object.find('/', end + 1);
        if (H5Lexists(file, object.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return true;
}

template <class T>
std::vector<T> read_all(hid_t file, const std::string& path, const std::string& dataset, hid_t type) {
    const std::string what = fmt::format("{}: dataset {}", path, dataset);
    const Handle set(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose, what);
    const Handle space(H5Dget_space(set), H5Sclose, what);
    std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) throw IoError(what + " cannot be read");
    return values;
}

}  // namespace

Hdf5Input::Hdf5Input(const std::filesystem::path& path) : path_(path.string()) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path_);
    H5Pset_file_locking(access, false, true);
    file_ = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access);
    if (file_ < 0) throw IoError(path_ + ": is missing or not a readable HDF5 file");
}

Hdf5Input::~Hdf5Input() { H5Fclose(file_); }

bool Hdf5Input::has(const std::string& object) const { return path_exists(file_, object); }

bool Hdf5Input::has_attribute(const std::string& object, const std::string& name) const {
    return has(object) && H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

double Hdf5Input::attribute(const std::string& object, const std::string& name) const {
    const std::string what = fmt::format("{}: attribute {} of {}", path_, name, object);
    if (!has_attribute(object, name)) throw IoError(what + " is missing");
    const Handle found(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
    double value = 0.0;
    if (H5Aread(found, H5T_NATIVE_DOUBLE, &value) < 0) throw IoError(what + " is not a number");
    return value;
}

std::vector<std::string> Hdf5Input::members(const std::string& group) const {
    std::vector<std::string> names;
    if (!has(group)) return names;
    const auto append = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->push_back(name);
        return 0;
    };
    const Handle found(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, fmt::format("{}: group {}", path_, group));
    hsize_t from = 0;
    if (H5Literate(found, H5_INDEX_NAME, H5_ITER_INC, &from, append, &names) < 0)
        throw IoError(fmt::format("{}: group {} cannot be listed", path_, group));
    return names;
}

std::vector<std::int64_t> Hdf5Input::shape(const std::string& dataset) const {
    const std::string what = fmt::format("{}: dataset {}", path_, dataset);
    const Handle set(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose, what);
    const Handle space(H5Dget_space(set), H5Sclose, what);
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return {extents.begin(), extents.end()};
}

std::vector<double> Hdf5Input::doubles(const std::string& dataset) const {
    return read_all<double>(file_, path_, dataset, H5T_NATIVE_DOUBLE);
}
std::vector<float> Hdf5Input::floats(const std::string& dataset) const {
    return read_all<float>(file_, path_, dataset, H5T_NATIVE_FLOAT);
}
std::vector<std::int32_t> Hdf5Input::integers(const std::string& dataset) const {
    return read_all<std::int32_t>(file_, path_, dataset, H5T_NATIVE_INT32);
}

}  // namespace tt
