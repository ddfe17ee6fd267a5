#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace tt::hdf5 {

/// An HDF5 identifier that closes itself.
class Id {
public:
    using Close = herr_t (*)(hid_t);
    Id() = default;
    Id(hid_t id, Close close) : id_(id), close_(close) {}
    ~Id() { reset(); }
    Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Id& operator=(Id&& other) noexcept {
        reset();
        id_ = std::exchange(other.id_, -1);
        close_ = other.close_;
        return *this;
    }
    operator hid_t() const { return id_; }
    void reset() {
        if (id_ >= 0) close_(id_);
        id_ = -1;
    }

private:
    hid_t id_ = -1;
    Close close_ = nullptr;
};

/// A file that exists in memory only; `image` hands out its bytes. HDF5 then never writes to a disk
/// itself, and a full disk is met by code that checks (`replace_file`). Files on a disk:
/// io/hdf5_driver.hpp.
Id create_in_memory();
std::string image(hid_t file);

Id create_group(hid_t where, const std::string& name);
Id open_group(hid_t where, const std::string& name);
bool exists(hid_t where, const std::string& name);
bool has_attribute(hid_t where, const std::string& name);
void remove(hid_t where, const std::string& name);
/// Names of all that a group holds, in order.
std::vector<std::string> names_in(hid_t group);

void write_attribute(hid_t where, const std::string& name, double value);
void write_attribute(hid_t where, const std::string& name, std::int64_t value);
void write_attribute(hid_t where, const std::string& name, std::span<const double> values);
void write_attribute(hid_t where, const std::string& name, const std::string& text);
double read_double(hid_t where, const std::string& name);
std::int64_t read_integer(hid_t where, const std::string& name);
std::vector<double> read_doubles(hid_t where, const std::string& name);
std::string read_text(hid_t where, const std::string& name);

enum class Storage : std::uint8_t { plain, compressed };

/// A dataset of shape `shape`, row after row, and its unit as attribute. Compressed: one chunk,
/// bytes shuffled, deflate at its fastest.
void write_dataset(hid_t where, const std::string& name, const std::vector<hsize_t>& shape,
                   std::span<const double> values, const std::string& unit,
                   Storage storage = Storage::plain);
void write_dataset(hid_t where, const std::string& name, const std::vector<hsize_t>& shape,
                   std::span<const float> values, const std::string& unit,
                   Storage storage = Storage::plain);
void write_dataset(hid_t where, const std::string& name, std::span<const std::int32_t> values);
void write_dataset(hid_t where, const std::string& name, std::span<const std::int64_t> values);
/// One-dimensional datasets that grow.
void create_growing(hid_t where, const std::string& name, hid_t type, const std::string& unit);
void append(hid_t where, const std::string& name, double value);
void append(hid_t where, const std::string& name, std::int64_t value);

/// A dataset's values and its shape. IoError if it is absent.
template <class T>
struct Dataset {
    std::vector<hsize_t> shape;
    std::vector<T> values;
};
template <class T>
Dataset<T> read_dataset(hid_t where, const std::string& name);
extern template Dataset<double> read_dataset(hid_t, const std::string&);
extern template Dataset<float> read_dataset(hid_t, const std::string&);
extern template Dataset<std::int32_t> read_dataset(hid_t, const std::string&);

/// Entry `name` of `where` that stands for `object` of another file, found relative to this file's
/// folder.
void link_external(hid_t where, const std::string& name, const std::string& file,
                   const std::string& object);

/// IoError naming the file unless the HDF5 call succeeded.
void expect(bool ok, const char* what, const std::string& name);

}  // namespace tt::hdf5
