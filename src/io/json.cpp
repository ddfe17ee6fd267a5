#include "io/json.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {

void write_json(const std::filesystem::path& path, const Json& value, Durability durability) {
    // Text of the user (a name, a command line) may hold bytes that are not UTF-8: replaced, never
    // an exception.
    const std::string text = value.dump(2, ' ', false, Json::error_handler_t::replace);
    replace_file(path, text + '\n', durability);
}

Json read_json(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    Json value = Json::parse(text, nullptr, false);
    if (value.is_discarded()) throw IoError(fmt::format("'{}' is not valid JSON", path.string()));
    return value;
}

}  // namespace tt
