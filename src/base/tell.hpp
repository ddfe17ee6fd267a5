#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace tt {

/// A message on stderr. Where it cannot be written (closed, a full disk, a reader that is gone) it
/// is lost, and nothing else: no simulation ends for it.
template <class... T>
void tell_user(fmt::format_string<T...> form, T&&... values) {
    std::fputs(fmt::format(form, std::forward<T>(values)...).c_str(), stderr);
}

}  // namespace tt
