#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace tt {

/// Text on stderr. Where it cannot be written (closed, a full disk, a reader that is gone) it is
/// lost, and nothing else: no simulation ends for it.
inline void write_plainly(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// How messages are written: as they are, unless set for programs that read them. Before threads
/// start.
inline std::function<void(const std::string&)> message_writer = write_plainly;

/// A message.
template <class... T>
void tell_user(fmt::format_string<T...> form, T&&... values) {
    message_writer(fmt::format(form, std::forward<T>(values)...));
}

}  // namespace tt
