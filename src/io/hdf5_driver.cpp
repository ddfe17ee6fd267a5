#include "io/hdf5_driver.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include "base/error.hpp"

namespace tt::hdf5 {

/// What the driver is given through the access list: one of the two.
struct Access {
    const SealedFile* from = nullptr;
    GuardedFile* to = nullptr;
    void write(haddr_t offset, const void* bytes, std::size_t count) const {
        if (to->error_) return;
        try {
            to->file_.write_at(offset, bytes, count);
        } catch (const IoError&) {
            to->error_ = std::current_exception();
        }
    }
};

namespace {

/// An open file as HDF5 sees it. H5FD_t must come first: HDF5 keeps its own there.
struct Open {
    H5FD_t known_to_hdf5{};
    Access access;
    haddr_t end_of_addresses = 0;
    haddr_t end_of_file = 0;
};

Open& ours(H5FD_t* file) { return *reinterpret_cast<Open*>(file); }
const Open& ours(const H5FD_t* file) { return *reinterpret_cast<const Open*>(file); }

H5FD_t* open(const char* /*name*/, unsigned /*flags*/, hid_t properties, haddr_t /*most*/) {
    const auto* access = static_cast<const Access*>(H5Pget_driver_info(properties));
    if (access == nullptr) return nullptr;
    auto file = std::make_unique<Open>();
    file->access = *access;
    if (access->from) file->end_of_file = access->from->size();
    return &file.release()->known_to_hdf5;
}

herr_t close(H5FD_t* file) {
    delete &ours(file);
    return 0;
}

herr_t query(const H5FD_t* /*file*/, unsigned long* features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

haddr_t get_end_of_addresses(const H5FD_t* file, H5FD_mem_t /*type*/) {
    return ours(file).end_of_addresses;
}

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t address) {
    ours(file).end_of_addresses = address;
    return 0;
}

haddr_t get_end_of_file(const H5FD_t* file, H5FD_mem_t /*type*/) { return ours(file).end_of_file; }

herr_t get_handle(H5FD_t* file, hid_t /*properties*/, void** handle) {
    *handle = &ours(file);
    return 0;
}

/// A file being written is never read: HDF5 keeps all that it may need again (see GuardedFile).
herr_t read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address,
            std::size_t count, void* bytes) {
    const SealedFile* const from = ours(file).access.from;
    return from && from->read(address, count, static_cast<char*>(bytes)) ? 0 : -1;
}

herr_t write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address,
             std::size_t count, const void* bytes) {
    Open& open = ours(file);
    if (open.access.to == nullptr) return -1;
    open.access.write(address, bytes, count);
    open.end_of_file = std::max(open.end_of_file, address + count);
    return 0;
}

/// Makes the file as long as its addresses say.
herr_t truncate(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
    Open& open = ours(file);
    if (open.access.to && open.end_of_file < open.end_of_addresses) {
        open.access.write(open.end_of_addresses - 1, "", 1);
        open.end_of_file = open.end_of_addresses;
    }
    return 0;
}

const H5FD_class_t& driver_class() {
    static const H5FD_class_t description = [] {
        const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
        H5FD_class_t c{};
#if H5_VERSION_GE(1, 13, 0)
        c.version = H5FD_CLASS_VERSION;
        c.value = static_cast<H5FD_class_value_t>(400);  // of those for use of one's own
#endif
        c.name = "tanktread";
        c.maxaddr = HADDR_MAX / 2;
        c.fc_degree = H5F_CLOSE_STRONG;
        c.fapl_size = sizeof(Access);
        c.open = open;
        c.close = close;
        c.query = query;
        c.get_eoa = get_end_of_addresses;
        c.set_eoa = set_end_of_addresses;
        c.get_eof = get_end_of_file;
        c.get_handle = get_handle;
        c.read = read;
        c.write = write;
        c.truncate = truncate;
        std::copy(std::begin(kinds), std::end(kinds), std::begin(c.fl_map));
        return c;
    }();
    return description;
}

Id access_through(const Access& access) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    static const hid_t driver = H5FDregister(&driver_class());
    Id properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    expect(properties >= 0 && H5Pset_driver(properties, driver, &access) >= 0, "prepare", "a file");
    return properties;
}

/// HDF5 then keeps all it has written of a file's structure, and never needs to read it back.
void keep_all_in_memory(hid_t properties) {
    H5AC_cache_config_t cache{};
    cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
    expect(H5Pget_mdc_config(properties, &cache) >= 0, "prepare", "a file");
    cache.evictions_enabled = false;
    cache.incr_mode = H5C_incr__off;
    cache.flash_incr_mode = H5C_flash_incr__off;
    cache.decr_mode = H5C_decr__off;
    expect(H5Pset_mdc_config(properties, &cache) >= 0, "prepare", "a file");
}

}  // namespace

Id open_sealed(const SealedFile& file) {
    const std::string name = file.path().string();
    const Id properties = access_through({&file, nullptr});
    Id id(H5Fopen(name.c_str(), H5F_ACC_RDONLY, properties), H5Fclose);
    void* handle = nullptr;
    expect(id >= 0 && H5Fget_vfd_handle(id, H5P_DEFAULT, &handle) >= 0, "open", name);
    const haddr_t end = static_cast<const Open*>(handle)->end_of_addresses;
    // HDF5 leaves no bytes behind its own: these were a seal.
    expect(file.has_seal() || end == file.size(), "trust the damaged checksums of", name);
    return id;
}

GuardedFile::GuardedFile(const std::filesystem::path& path)
    : file_(path, OutputFile::Mode::create) {
    const Id properties = access_through({nullptr, this});
    keep_all_in_memory(properties);
    id_ = Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, properties), H5Fclose);
    expect(id_ >= 0, "create", path.string());
}

void GuardedFile::expect_sound() const {
    if (error_) std::rethrow_exception(error_);
}

void GuardedFile::close() {
    expect(H5Fflush(id_, H5F_SCOPE_GLOBAL) >= 0, "flush", file_.path().string());
    id_.reset();
    expect_sound();
    file_.close();
}

}  // namespace tt::hdf5
