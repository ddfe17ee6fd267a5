#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace tt {

/// What writes messages on stderr: as they are, unless another way was set, as for programs that
/// read them. Where one cannot be written (closed, a full disk, a reader that is gone) it is lost,
/// and nothing else: no simulation ends for it.
inline void write_plainly(const std::string& text) { std::fputs(text.c_str(), stderr); }
inline std::function<void(const std::string&)> message_writer = write_plainly;

template <class... T>
void tell_user(fmt::format_string<T...> form, T&&... values) {
    message_writer(fmt::format(form, std::forward<T>(values)...));
}

}  // namespace tt
