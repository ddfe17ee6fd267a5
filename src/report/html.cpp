#include "report/html.hpp"

#include <utility>

#include <fmt/format.h>

namespace tt {
namespace {

std::string class_attribute(std::string_view kind) {
    return kind.empty() ? "" : fmt::format(" class=\"{}\"", kind);
}

}  // namespace

std::string html(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\'')
            result += "&#39;";
        else
            result += c;
    }
    return result;
}

std::string heading(std::string_view id, std::string_view title) {
    return fmt::format("<h2 id=\"{0}\"><a href=\"#{0}\">{1}</a></h2>\n", id, html(title));
}

std::string contents_list(std::string_view page) {
    constexpr std::string_view start = "<h2 id=", link = "<a href=\"#", end = "</a>";
    std::string list = "<nav aria-label=\"Contents\"><ul>\n";
    for (std::size_t at = 0; (at = page.find(start, at)) != std::string_view::npos; ++at) {
        const std::size_t from = page.find(link, at), to = page.find(end, from);
        if (to == std::string_view::npos) break;
        list += fmt::format("<li>{}{}</li>\n", page.substr(from, to - from), end);
    }
    return list + "</ul></nav>\n";
}

HtmlTable::HtmlTable(std::string_view caption, std::vector<Column> columns)
    : caption_(caption), columns_(std::move(columns)) {}

void HtmlTable::add_row(const std::vector<std::string>& texts, std::string_view kind) {
    rows_ +=
        fmt::format("<tr{}><th scope=\"row\">{}</th>", class_attribute(kind), html(texts.front()));
    for (std::size_t c = 1; c < columns_.size(); ++c) {
        rows_ += fmt::format("<td{} data-label=\"{}\">{}</td>", class_attribute(columns_[c].kind),
                             html(columns_[c].title), html(texts[c]));
    }
    rows_ += "</tr>\n";
}

std::string HtmlTable::text() const {
    std::string head, caption;
    for (const Column& column : columns_) {
        // Only numbers want their title on their side; other classes are about the cells.
        const std::string_view kind = column.kind == "number" ? "number" : "";
        head +=
            fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(kind), html(column.title));
    }
    if (!caption_.empty()) caption = fmt::format("<caption>{}</caption>\n", html(caption_));
    return fmt::format(
        "<div "
        "class=\"scroll\"><table>{}<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
        caption, head, rows_);
}

std::string embedded(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t k = 0; (k = text.find('<', k)) != std::string::npos;) {
        text.replace(k, 1, "\\u003c");
    }
    return text;
}

}  // namespace tt
