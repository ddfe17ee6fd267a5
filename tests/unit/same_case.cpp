#include "observe/same_case.hpp"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "case/field_types.hpp"
#include "case/read.hpp"
#include "case/resolve.hpp"
#include "base/words.hpp"
#include "case/schema.hpp"

namespace tt {
namespace {

const char* const small_case = R"(format = 1
domain = { length = "20 um", width = "12 um" }
flow = { drive = "pressure", pseudo_shear_rate = "200 /s" }
cells = { count = 1, radius = "2.7 um" }
numerics = { dx = "0.5 um" }
time = { end = "4 ms" }
)";

/// A value that is another one, whatever its type; it need make no sense.
void change(bool& value) { value = !value; }
void change(std::int64_t& value) { ++value; }
void change(double& value) { value = 0.5 + 2.0 * value; }
void change(std::string& value) { value += "x"; }
template <Dimension D>
void change(Quantity<D>& value) {
    change(value.si);
}
template <Choosable T>
void change(T& choice) {
    const std::vector<std::string_view> words = split(all_words<T>(), '|');
    choose_word(words.front() == word_of(choice) ? words.back() : words.front(), choice);
}
template <class T>
void change(std::optional<T>& value) {
    if (!value) value.emplace();
    change(*value);
}
template <class T>
void change(std::vector<T>& values) {
    values.emplace_back();
}

/// Calls `see(key, changed case)` for every key of the schema, one changed at a time.
template <class S, class Of, class See>
void change_each(const Case& c, const std::string& path, const Of& of, const See& see) {
    Case copy = c;
    for_each_field<S>([&](const auto& field) {
        using T = std::remove_cvref_t<decltype(std::declval<S&>().*field.member)>;
        const std::string key = path + std::string(field.key);
        const auto deeper = [&of, member = field.member](Case& whole) -> T& {
            return of(whole).*member;
        };
        if constexpr (TomlTable<T>) {
            change_each<T>(c, key + ".", deeper, see);
        } else if constexpr (is_tables<T>) {
            Case changed = c;
            std::string one = "1";
            auto& item = deeper(changed).emplace_back();
            if constexpr (requires { item.name; }) one = item.name = "one";
            for_each_field<item_type<T>>([&](const auto& own) {
                const std::string of_one = key + "." + one + "." + std::string(own.key);
                using Own =
                    std::remove_cvref_t<decltype(std::declval<item_type<T>&>().*own.member)>;
                if constexpr (TomlTable<Own>)
                    for_each_field<Own>([&](const auto& deep) {
                        see(of_one + "." + std::string(deep.key), changed);
                    });
                else
                    see(of_one, changed);
            });
        } else {
            Case changed = c;
            change(deeper(changed));
            see(key, changed);
        }
        if constexpr (has_keys<T>) {
            std::visit(
                [&]<class A>(const A&) {
                    const auto chosen = [&](Case& whole) -> A& {
                        return std::get<A>(deeper(whole));
                    };
                    if constexpr (Fielded<A>) change_each<A>(c, path, chosen, see);
                },
                deeper(copy));
        }
    });
}

TEST(SameCase, each_key_of_the_schema_is_told_where_it_differs) {
    const Case c = parse_case(small_case, "case.toml");
    const Choice choice = choose(c);
    const std::string settings = settings_of(c, choice);
    int keys = 0;
    change_each<Case>(
        c, "", [](Case& whole) -> Case& { return whole; },
        [&](const std::string& key, const Case& changed) {
            ++keys;
            const std::string other = settings_of(changed, choice);
            EXPECT_NE(other, settings) << key;
            const bool free =
                key == "name" || key.rfind("time.", 0) == 0 || key.rfind("output.", 0) == 0;
            try {
                expect_same_case("results", settings, other);
                EXPECT_TRUE(free) << key;
            } catch (const DirectoryInUse& error) {
                EXPECT_FALSE(free) << key;
                EXPECT_NE(std::string(error.what()).find("\n  " + key + ": "), std::string::npos)
                    << error.what();
            }
        });
    EXPECT_GT(keys, 50);
}

TEST(SameCase, what_the_program_chose_otherwise_is_told) {
    const Case c = parse_case(small_case, "case.toml");
    Choice choice = choose(c);
    const std::string settings = settings_of(c, choice);
    choice.dt.si *= 1.1;
    EXPECT_THROW(expect_same_case("results", settings, settings_of(c, choice)), DirectoryInUse);
}

}  // namespace
}  // namespace tt
