#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json.hpp"

namespace tt {

/// Text that shows as itself in HTML.
std::string html(std::string_view text);

/// The heading of a section, which is a link to itself. `id` is letters and hyphens.
std::string heading(std::string_view id, std::string_view title);

/// Links to all such headings of a page, in their order.
std::string contents_list(std::string_view page);

/// A table of an HTML page. The first cell of a row is its head; texts are escaped.
class HtmlTable {
public:
    struct Column {
        std::string title;
        std::string kind;  ///< class of its cells: number | meaning | word | nothing
    };
    HtmlTable(std::string_view caption, std::vector<Column> columns);

    /// `kind` is the class of the row. Precondition: one text per column.
    void add_row(const std::vector<std::string>& texts, std::string_view kind = "");
    std::string text() const;

private:
    std::string caption_;
    std::vector<Column> columns_;
    std::string rows_;
};

/// JSON that cannot end the script element it stands in.
std::string embedded(const Json& json);

}  // namespace tt
