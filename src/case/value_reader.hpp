#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/field_list.hpp"
#include "base/units.hpp"
#include "io/toml.hpp"

namespace tt {

/// A field without its type: what faults need to say.
struct FieldText {
    std::string_view key;
    Range range;
    std::string_view choices;
    std::string_view example;
};

/// Reads single values of a TOML text, telling each fault with its place and what to write. A value
/// that could not be read keeps its default.
class ValueReader {
public:
    explicit ValueReader(std::string file) : file_(std::move(file)) {}

    std::vector<Fault> faults;

protected:
    const std::string& file() const { return file_; }
    Fault place(const TomlEntry& entry, int line, int column) const {
        if (!entry.origin.empty()) return {entry.origin, 0, 0, {}};
        return {file_, line, column, {}};
    }
    void tell(const TomlEntry& entry, const TomlNode& value, std::string message);
    void tell_key(const TomlEntry& entry, std::string message);

    template <Dimension D>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    Quantity<D>& result) {
        if (const auto si = measure(entry, node, field, D)) result.si = *si;
    }
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    double& result);
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::int64_t& result);
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    bool& result);
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::string& result);
    /// Of whatever dimension it is given in.
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    Measure& result);

    static std::string shown(const TomlNode& node);
    /// The parts of "shear, area" or "[shear, area]" of the command line.
    static std::vector<TomlNode> listed_items(std::string_view text);

private:
    std::optional<double> measure(const TomlEntry& entry, const TomlNode& node,
                                  const FieldText& field, Dimension dimension);
    bool in_range(const TomlEntry& entry, const TomlNode& node, const FieldText& field, double si);

    std::string file_;
};

}  // namespace tt
