#include "io/json.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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

Json read_object(const std::filesystem::path& path) {
    try {
        Json object = read_json(path);
        if (object.is_object()) return object;
    } catch (const IoError&) {
    }
    return Json::object();
}

double number_of(const Json& object, const char* key, double otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

std::int64_t whole_number_of(const Json& object, const char* key, std::int64_t otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>()
                                                               : otherwise;
}

std::string text_of(const Json& object, const char* key, const std::string& otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

}  // namespace tt
