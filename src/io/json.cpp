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
    // Writing one follows its nesting by recursion.
    const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
        constexpr int deepest = 64;
        if (depth > deepest) throw IoError(fmt::format("'{}' is nested too deeply", path.string()));
        return true;
    };
    Json value = Json::parse(text, shallow, false);
    if (value.is_discarded()) throw IoError(fmt::format("'{}' is not valid JSON", path.string()));
    return value;
}

}  // namespace tt
