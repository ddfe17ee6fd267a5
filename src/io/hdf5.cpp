#include "io/hdf5.hpp"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt::hdf5 {
namespace {

/// HDF5 prints its error stack by default; ours are exceptions.
void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Id checked(hid_t id, Id::Close close, const char* what, const std::string& name) {
    expect(id >= 0, what, name);
    return {id, close};
}

Id scalar_space() { return checked(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar", ""); }

Id simple_space(const std::vector<hsize_t>& shape) {
    return checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                   H5Sclose, "create an array", "");
}

/// Text of any length: h5py hands it out as str, where it makes bytes of a text of fixed length.
Id text_type() {
    Id type = checked(H5Tcopy(H5T_C_S1), H5Tclose, "create a text type", "");
    expect(H5Tset_size(type, H5T_VARIABLE) >= 0, "size a text", "");
    expect(H5Tset_cset(type, H5T_CSET_UTF8) >= 0, "encode a text", "");
    return type;
}

void put_attribute(hid_t where, const std::string& name, hid_t type, hid_t space,
                   const void* value) {
    const Id attribute =
        checked(H5Acreate2(where, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                "create the attribute", name);
    expect(H5Awrite(attribute, type, value) >= 0, "write the attribute", name);
}

Id open_attribute(hid_t where, const std::string& name) {
    be_quiet();
    return checked(H5Aopen(where, name.c_str(), H5P_DEFAULT), H5Aclose, "find the attribute", name);
}

/// Without the time of day: the same frames make the same bytes.
Id creation() {
    Id properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "prepare", "a dataset");
    expect(H5Pset_obj_track_times(properties, false) >= 0, "prepare", "a dataset");
    return properties;
}

Id create_dataset(hid_t where, const std::string& name, hid_t type, hid_t space, hid_t properties) {
    return checked(
        H5Dcreate2(where, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
        H5Dclose, "create the dataset", name);
}

Id open_dataset(hid_t where, const std::string& name) {
    be_quiet();
    return checked(H5Dopen2(where, name.c_str(), H5P_DEFAULT), H5Dclose, "find the dataset", name);
}

void put_dataset(hid_t where, const std::string& name, const std::vector<hsize_t>& shape,
                 hid_t type, const void* values, const std::string& unit, Storage storage) {
    const Id properties = creation();
    const bool empty = std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end();
    if (storage == Storage::compressed && !empty) {
        constexpr unsigned fastest = 1;
        const bool done =
            H5Pset_chunk(properties, static_cast<int>(shape.size()), shape.data()) >= 0 &&
            H5Pset_shuffle(properties) >= 0 && H5Pset_deflate(properties, fastest) >= 0;
        expect(done, "compress", name);
    }
    const Id dataset = create_dataset(where, name, type, simple_space(shape), properties);
    expect(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, "write the dataset",
           name);
    if (!unit.empty()) write_attribute(dataset, "unit", unit);
}

void append_value(hid_t where, const std::string& name, hid_t type, const void* value) {
    const Id dataset = open_dataset(where, name);
    hsize_t count = 0;
    H5Sget_simple_extent_dims(checked(H5Dget_space(dataset), H5Sclose, "size", name), &count,
                              nullptr);
    const hsize_t one = 1, more = count + 1;
    expect(H5Dset_extent(dataset, &more) >= 0, "extend", name);
    const Id space = checked(H5Dget_space(dataset), H5Sclose, "size", name);
    expect(H5Sselect_hyperslab(space, H5S_SELECT_SET, &count, nullptr, &one, nullptr) >= 0 &&
               H5Dwrite(dataset, type, simple_space({1}), space, H5P_DEFAULT, value) >= 0,
           "append to", name);
}

template <class T>
hid_t native_type();
template <>
hid_t native_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
hid_t native_type<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
hid_t native_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}

}  // namespace

void expect(bool ok, const char* what, const std::string& name) {
    if (!ok) throw IoError(fmt::format("HDF5 cannot {} '{}'", what, name));
}

Id create_in_memory() {
    be_quiet();
    const Id access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare", "a file in memory");
    constexpr std::size_t growth = 1 << 20;
    expect(H5Pset_fapl_core(access, growth, 0) >= 0, "prepare", "a file in memory");
    // HDF5 refuses a second open file of the same name, even in memory.
    static std::atomic<int> number{0};
    const std::string name = fmt::format("in-memory-{}", number++);
    return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "create",
                   name);
}

std::string image(hid_t file) {
    expect(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "flush", "a file in memory");
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    expect(size > 0, "size", "a file in memory");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    expect(H5Fget_file_image(file, bytes.data(), bytes.size()) == size, "copy", "a file in memory");
    return bytes;
}

Id create_group(hid_t where, const std::string& name) {
    return checked(H5Gcreate2(where, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                   "create the group", name);
}

Id open_group(hid_t where, const std::string& name) {
    be_quiet();
    return checked(H5Gopen2(where, name.c_str(), H5P_DEFAULT), H5Gclose, "find the group", name);
}

bool exists(hid_t where, const std::string& name) {
    return H5Lexists(where, name.c_str(), H5P_DEFAULT) > 0;
}

bool has_attribute(hid_t where, const std::string& name) {
    return H5Aexists(where, name.c_str()) > 0;
}

std::vector<std::string> names_in(hid_t group) {
    H5G_info_t info{};
    expect(H5Gget_info(group, &info) >= 0, "count", "a group");
    std::vector<std::string> names;
    for (hsize_t k = 0; k < info.nlinks; ++k) {
        char name[64] = "";
        expect(H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name,
                                  H5P_DEFAULT) > 0,
               "name", "an entry of a group");
        names.emplace_back(name);
    }
    return names;
}

void write_attribute(hid_t where, const std::string& name, double value) {
    put_attribute(where, name, H5T_NATIVE_DOUBLE, scalar_space(), &value);
}

void write_attribute(hid_t where, const std::string& name, std::int64_t value) {
    put_attribute(where, name, H5T_NATIVE_INT64, scalar_space(), &value);
}

void write_attribute(hid_t where, const std::string& name, std::span<const double> values) {
    put_attribute(where, name, H5T_NATIVE_DOUBLE, simple_space({values.size()}), values.data());
}

void write_attribute(hid_t where, const std::string& name, const std::string& text) {
    const char* const start = text.c_str();
    put_attribute(where, name, text_type(), scalar_space(), &start);
}

double read_double(hid_t where, const std::string& name) {
    double value = 0.0;
    expect(H5Aread(open_attribute(where, name), H5T_NATIVE_DOUBLE, &value) >= 0,
           "read the attribute", name);
    return value;
}

std::int64_t read_integer(hid_t where, const std::string& name) {
    std::int64_t value = 0;
    expect(H5Aread(open_attribute(where, name), H5T_NATIVE_INT64, &value) >= 0,
           "read the attribute", name);
    return value;
}

std::vector<double> read_doubles(hid_t where, const std::string& name) {
    const Id attribute = open_attribute(where, name);
    const Id space = checked(H5Aget_space(attribute), H5Sclose, "read the attribute", name);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    expect(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()) >= 0, "read the attribute", name);
    return values;
}

std::string read_text(hid_t where, const std::string& name) {
    char* start = nullptr;
    expect(H5Aread(open_attribute(where, name), text_type(), &start) >= 0 && start != nullptr,
           "read the attribute", name);
    const std::string text = start;
    H5free_memory(start);
    return text;
}

void write_dataset(hid_t where, const std::string& name, const std::vector<hsize_t>& shape,
                   std::span<const double> values, const std::string& unit, Storage storage) {
    put_dataset(where, name, shape, H5T_NATIVE_DOUBLE, values.data(), unit, storage);
}

void write_dataset(hid_t where, const std::string& name, const std::vector<hsize_t>& shape,
                   std::span<const float> values, const std::string& unit, Storage storage) {
    put_dataset(where, name, shape, H5T_NATIVE_FLOAT, values.data(), unit, storage);
}

void write_dataset(hid_t where, const std::string& name, std::span<const std::int32_t> values) {
    put_dataset(where, name, {values.size()}, H5T_NATIVE_INT32, values.data(), "", Storage::plain);
}

void write_dataset(hid_t where, const std::string& name, std::span<const std::int64_t> values) {
    put_dataset(where, name, {values.size()}, H5T_NATIVE_INT64, values.data(), "", Storage::plain);
}

void create_growing(hid_t where, const std::string& name, hid_t type, const std::string& unit) {
    const hsize_t none = 0, any = H5S_UNLIMITED, piece = 512;
    const Id properties = creation();
    expect(H5Pset_chunk(properties, 1, &piece) >= 0, "prepare", name);
    const Id space = checked(H5Screate_simple(1, &none, &any), H5Sclose, "create an array", name);
    const Id dataset = create_dataset(where, name, type, space, properties);
    if (!unit.empty()) write_attribute(dataset, "unit", unit);
}

void append(hid_t where, const std::string& name, double value) {
    append_value(where, name, H5T_NATIVE_DOUBLE, &value);
}

void append(hid_t where, const std::string& name, std::int64_t value) {
    append_value(where, name, H5T_NATIVE_INT64, &value);
}

template <class T>
Dataset<T> read_dataset(hid_t where, const std::string& name) {
    const Id dataset = open_dataset(where, name);
    const Id space = checked(H5Dget_space(dataset), H5Sclose, "read the dataset", name);
    Dataset<T> result;
    result.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, result.shape.data(), nullptr);
    result.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    expect(H5Dread(dataset, native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                   result.values.data()) >= 0,
           "read the dataset", name);
    return result;
}
template Dataset<double> read_dataset(hid_t, const std::string&);
template Dataset<float> read_dataset(hid_t, const std::string&);
template Dataset<std::int32_t> read_dataset(hid_t, const std::string&);

void remove(hid_t where, const std::string& name) {
    expect(H5Ldelete(where, name.c_str(), H5P_DEFAULT) >= 0, "remove", name);
}

void link_external(hid_t where, const std::string& name, const std::string& file,
                   const std::string& object) {
    expect(H5Lcreate_external(file.c_str(), object.c_str(), where, name.c_str(), H5P_DEFAULT,
                              H5P_DEFAULT) >= 0,
           "link", file);
}

}  // namespace tt::hdf5
