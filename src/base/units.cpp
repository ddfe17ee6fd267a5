#include "base/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

#include "base/words.hpp"

namespace tt {
namespace {

/// Factor to SI, exact: numerator / denominator · 10^exponent, times `irrational` for degrees only.
struct Unit {
    Dimension dimension;
    int exponent = 0;
    std::uint64_t numerator = 1;
    std::uint64_t denominator = 1;
    double irrational = 1.0;
};

struct Symbol {
    std::string_view name;
    Unit unit;
    enum { plain, takes_prefix } kind = plain;
};

constexpr double degree = 3.14159265358979323846 / 180.0;

/// mmHg is the conventional millimetre of mercury, 133.322387415 Pa (BIPM, SI Brochure, 8th ed.,
/// table 8).
constexpr std::array symbols{
    Symbol{"m", {{0, 1, 0}}, Symbol::takes_prefix},
    Symbol{"g", {{1, 0, 0}, -3}, Symbol::takes_prefix},
    Symbol{"s", {{0, 0, 1}}, Symbol::takes_prefix},
    Symbol{"min", {{0, 0, 1}, 1, 6}},
    Symbol{"h", {{0, 0, 1}, 2, 36}},
    Symbol{"Hz", {{0, 0, -1}}, Symbol::takes_prefix},
    Symbol{"N", {{1, 1, -2}}, Symbol::takes_prefix},
    Symbol{"dyn", {{1, 1, -2}, -5}, Symbol::takes_prefix},
    Symbol{"J", {{1, 2, -2}}, Symbol::takes_prefix},
    Symbol{"erg", {{1, 2, -2}, -7}, Symbol::takes_prefix},
    Symbol{"Pa", {{1, -1, -2}}, Symbol::takes_prefix},
    Symbol{"bar", {{1, -1, -2}, 5}, Symbol::takes_prefix},
    Symbol{"mmHg", {{1, -1, -2}, -9, 133322387415}},
    Symbol{"P", {{1, -1, -1}, -1}, Symbol::takes_prefix},
    Symbol{"St", {{0, 2, -1}, -4}, Symbol::takes_prefix},
    Symbol{"L", {{0, 3, 0}, -3}, Symbol::takes_prefix},
    Symbol{"%", {{}, -2}},
    Symbol{"1", {}},
    Symbol{"rad", {{0, 0, 0, 1}}},
    Symbol{"deg", {{0, 0, 0, 1}, 0, 1, 1, degree}},
};

struct Prefix {
    char letter;
    int exponent;
};
constexpr std::array prefixes{Prefix{'f', -15}, Prefix{'p', -12}, Prefix{'n', -9},
                              Prefix{'u', -6},  Prefix{'m', -3},  Prefix{'c', -2},
                              Prefix{'k', 3},   Prefix{'M', 6},   Prefix{'G', 9}};

/// What people write for a unit that has another symbol here.
struct Alias {
    std::string_view name;
    std::string_view symbol;
};
constexpr std::array aliases{
    Alias{"micron", "um"},  Alias{"microns", "um"},  Alias{"mum", "um"},    Alias{"mu", "um"},
    Alias{"sec", "s"},      Alias{"second", "s"},    Alias{"seconds", "s"}, Alias{"msec", "ms"},
    Alias{"usec", "us"},    Alias{"mPas", "mPa s"},  Alias{"Pas", "Pa s"},  Alias{"Pa.s", "Pa s"},
    Alias{"dyne", "dyn"},   Alias{"dynes", "dyn"},   Alias{"cp", "cP"},     Alias{"percent", "%"},
    Alias{"degree", "deg"}, Alias{"degrees", "deg"}, Alias{"hour", "h"},    Alias{"l", "L"},
};

/// The dimensions people name, and the units they use for them; the SI unit stands first.
struct Customary {
    Dimension dimension;
    std::string_view name;
    std::array<std::string_view, 5> units;
};
constexpr std::array customary{
    Customary{{}, "plain number", {""}},
    Customary{{0, 0, 0, 1}, "angle", {"rad", "deg"}},
    Customary{{0, 1, 0}, "length", {"m", "um", "nm", "mm", "cm"}},
    Customary{{0, 2, 0}, "area", {"m^2", "um^2", "mm^2"}},
    Customary{{0, 3, 0}, "volume", {"m^3", "um^3"}},
    Customary{{0, 0, 1}, "time", {"s", "ms", "us", "ns", "min"}},
    Customary{{0, 0, -1}, "rate", {"/s", "/ms", "/us"}},
    Customary{{0, -1, 0}, "inverse length", {"/m", "/um", "/mm"}},
    Customary{{0, 1, -1}, "velocity", {"m/s", "mm/s", "um/s"}},
    Customary{{0, 1, -2}, "acceleration", {"m/s^2"}},
    Customary{{1, 0, 0}, "mass", {"kg", "g", "mg", "ug"}},
    Customary{{1, 1, -2}, "force", {"N", "pN", "nN", "uN"}},
    Customary{{1, -3, 0}, "density", {"kg/m^3"}},
    Customary{{1, -1, -1}, "viscosity", {"Pa s", "cP"}},
    Customary{{0, 2, -1}, "kinematic viscosity", {"m^2/s", "mm^2/s"}},
    Customary{{1, -1, -2}, "pressure", {"Pa", "kPa", "MPa", "mPa"}},
    Customary{{1, -2, -2}, "pressure gradient", {"Pa/m", "kPa/m"}},
    Customary{{1, 0, -2}, "tension (an energy per area)", {"N/m", "uN/m", "mN/m"}},
    Customary{{1, 2, -2}, "bending modulus (an energy)", {"J"}},
};

const Customary* find_customary(Dimension dimension) {
    for (const Customary& c : customary)
        if (c.dimension == dimension) return &c;
    return nullptr;
}

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t limit = std::uint64_t{1}
                                    << 59;  // times a digit, plus carry, still fits 64 bits
    if (a != 0 && b > limit / a) throw UnitError("a unit this large or small has no use here");
    return a * b;
}

Unit times(const Unit& a, const Unit& b, int power) {
    Unit r = a;
    r.dimension.kg += power * b.dimension.kg;
    r.dimension.m += power * b.dimension.m;
    r.dimension.s += power * b.dimension.s;
    r.dimension.rad += power * b.dimension.rad;
    r.exponent += power * b.exponent;
    for (int i = 0; i < std::abs(power); ++i) {
        r.numerator = product(r.numerator, power > 0 ? b.numerator : b.denominator);
        r.denominator = product(r.denominator, power > 0 ? b.denominator : b.numerator);
        r.irrational = power > 0 ? r.irrational * b.irrational : r.irrational / b.irrational;
    }
    return r;
}

std::optional<Unit> find_unit(std::string_view name) {
    for (const Symbol& s : symbols)
        if (s.name == name) return s.unit;
    if (name.size() < 2) return std::nullopt;
    for (const Prefix& p : prefixes) {
        if (p.letter != name.front()) continue;
        for (const Symbol& s : symbols) {
            if (s.kind != Symbol::takes_prefix || s.name != name.substr(1)) continue;
            Unit u = s.unit;
            u.exponent += p.exponent;
            return u;
        }
    }
    return std::nullopt;
}

std::string unknown_unit(std::string_view name) {
    for (const Alias& a : aliases)
        if (a.name == name) return fmt::format("unknown unit '{}'; write '{}'", name, a.symbol);
    std::vector<std::string_view> known{"um",  "nm",  "mm", "cm", "ms", "us", "cP",
                                        "mPa", "kPa", "kg", "uN", "mN", "pN"};
    for (const Symbol& s : symbols) known.push_back(s.name);
    if (const auto near = closest(name, known))
        return fmt::format("unknown unit '{}'; did you mean '{}'?", name, *near);
    return fmt::format("unknown unit '{}'", name);
}

/// Recursive descent over: unit = ["/"] factor { ("*" | " " | "/") factor }; factor = symbol [["^"]
/// power] | "(" unit ")".
class UnitParser {
public:
    explicit UnitParser(std::string_view text) : text_(text) {}

    Unit parse() {
        const Unit u = parse_product(0);
        if (position_ < text_.size())
            throw UnitError(fmt::format("'{}' is not expected in a unit", text_[position_]));
        return u;
    }

private:
    void skip_spaces() {
        while (position_ < text_.size() && text_[position_] == ' ') ++position_;
    }
    bool at_end() const { return position_ >= text_.size() || text_[position_] == ')'; }

    Unit parse_product(int depth) {
        if (depth > 4) throw UnitError("too many brackets in a unit");
        Unit u;
        bool divided = false;
        skip_spaces();
        for (bool first = true; first || !at_end(); first = false) {
            int sign = 1;
            if (position_ < text_.size() &&
                (text_[position_] == '/' || (text_[position_] == '*' && !first))) {
                sign = text_[position_++] == '/' ? -1 : 1;
                skip_spaces();
            }
            // a/b c is read as (a/b)·c by some and a/(b c) by others.
            if (divided && sign > 0)
                throw UnitError(
                    "what stands under '/' is ambiguous; write brackets, as in kg/(m s)");
            divided = divided || sign < 0;
            u = times(u, parse_factor(depth), sign);
            skip_spaces();
        }
        return u;
    }

    Unit parse_factor(int depth) {
        Unit u;
        if (position_ < text_.size() && text_[position_] == '(') {
            ++position_;
            u = parse_product(depth + 1);
            if (position_ >= text_.size()) throw UnitError("a bracket is not closed");
            ++position_;
        } else {
            u = parse_symbol();
        }
        return times(Unit{}, u, parse_power());
    }

    Unit parse_symbol() {
        const std::size_t begin = position_;
        if (position_ < text_.size() && (text_[position_] == '%' || text_[position_] == '1'))
            ++position_;
        else
            while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
        const std::string_view name = text_.substr(begin, position_ - begin);
        if (name.empty() && position_ < text_.size())
            throw UnitError(fmt::format("'{}' is not expected in a unit", text_[position_]));
        if (name.empty()) throw UnitError("a unit is missing at the end");
        if (const auto unit = find_unit(name)) return *unit;
        throw UnitError(unknown_unit(name));
    }

    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

    int parse_power() {
        std::size_t p = position_;
        if (p < text_.size() && text_[p] == '^')
            ++p;
        else if (p >= text_.size() || text_[p] < '2' || text_[p] > '9')
            return 1;
        int power = 0;
        const char* begin = text_.data() + p;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), power);
        if (error != std::errc() || power == 0 || std::abs(power) > 6)
            throw UnitError("a power in a unit is a whole number from -6 to 6, as in m^3");
        position_ = p + static_cast<std::size_t>(end - begin);
        return power;
    }

    std::string_view text_;
    std::size_t position_ = 0;
};

/// The digits of a decimal number and the power of ten of the last one.
struct Decimal {
    bool negative = false;
    std::string digits;
    long exponent = 0;
};

Decimal to_decimal(std::string_view number) {
    Decimal d;
    std::size_t i = 0;
    if (number[i] == '+' || number[i] == '-') d.negative = number[i++] == '-';
    bool fraction = false;
    for (; i < number.size() && number[i] != 'e' && number[i] != 'E'; ++i) {
        if (number[i] == '.') {
            fraction = true;
            continue;
        }
        d.digits += number[i];
        if (fraction) --d.exponent;
    }
    if (i < number.size()) {
        const char* begin = number.data() + i + 1 + (number[i + 1] == '+' ? 1 : 0);
        long e = 0;
        const auto [end, error] = std::from_chars(begin, number.data() + number.size(), e);
        if (error != std::errc() || std::labs(e) > 1000)
            throw UnitError("the number is too large or too small");
        static_cast<void>(end);
        d.exponent += e;
    }
    return d;
}

/// digits · factor, in decimal.
std::string multiply(const std::string& digits, std::uint64_t factor) {
    std::string result;
    std::uint64_t carry = 0;
    for (auto it = digits.rbegin(); it != digits.rend() || carry > 0;) {
        if (it != digits.rend()) carry += static_cast<std::uint64_t>(*it++ - '0') * factor;
        result += static_cast<char>('0' + carry % 10);
        carry /= 10;
    }
    return {result.rbegin(), result.rend()};
}

/// The double nearest to `number` in `unit`: one rounding unless the unit has a denominator or a
/// degree in it.
double to_si(std::string_view number, const Unit& unit) {
    Decimal d = to_decimal(number);
    if (unit.numerator != 1) d.digits = multiply(d.digits, unit.numerator);
    const std::string text =
        fmt::format("{}{}e{}", d.negative ? "-" : "", d.digits, d.exponent + unit.exponent);
    double si = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), si);
    static_cast<void>(end);
    if (error != std::errc()) throw UnitError("the number is too large or too small");
    return si / static_cast<double>(unit.denominator) * unit.irrational;
}

/// number · 10^−shift, exactly, as people write it.
std::string shifted_text(double number, int shift) {
    if (number == 0.0) return "0";
    std::array<char, 40> buffer{};
    const auto done = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                    std::chars_format::scientific);
    const Decimal d =
        to_decimal({buffer.data(), static_cast<std::size_t>(done.ptr - buffer.data())});
    const long count = static_cast<long>(d.digits.size());
    const long point = d.exponent - shift + count;  // digits before the decimal point
    const std::string sign = d.negative ? "-" : "";
    if (point > 7 || point < -3) {
        return fmt::format("{}{}{}{}e{}", sign, d.digits[0], count > 1 ? "." : "",
                           d.digits.substr(1), point - 1);
    }
    if (point <= 0)
        return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + d.digits;
    if (point >= count)
        return sign + d.digits + std::string(static_cast<std::size_t>(point - count), '0');
    return sign + d.digits.substr(0, static_cast<std::size_t>(point)) + "." +
           d.digits.substr(static_cast<std::size_t>(point));
}

std::string joined(const std::string& number, std::string_view unit) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

/// The fewest digits in a unit that is no power of ten (min, h, deg) that read back to the same
/// bits; empty if none do.
std::string searched_text(double si, const Unit& unit, std::string_view name) {
    const double factor = to_si("1", unit);
    for (int digits = 1; digits <= 17; ++digits) {
        const std::string number = fmt::format("{:.{}g}", si / factor, digits);
        if (to_si(number, unit) == si) return joined(number, name);
    }
    return {};
}

}  // namespace

std::size_t number_length(std::string_view text) {
    const auto digits = [&](std::size_t at) {
        std::size_t n = 0;
        while (at + n < text.size() && std::isdigit(static_cast<unsigned char>(text[at + n]))) ++n;
        return n;
    };
    std::size_t i = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t whole = digits(i);
    i += whole;
    std::size_t fraction = 0;
    if (i < text.size() && text[i] == '.') {
        fraction = digits(i + 1);
        i += 1 + fraction;
    }
    if (whole + fraction == 0) return 0;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        const std::size_t sign =
            i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-') ? 1 : 0;
        if (const std::size_t power = digits(i + 1 + sign)) i += 1 + sign + power;
    }
    return i;
}

Measure parse_measure(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    if (text.size() > 200) throw UnitError("is too long for a number with a unit");
    const std::size_t length = number_length(text);
    if (length == 0) throw UnitError("does not start with a number");
    if (length < text.size() && text[length] == ',')
        throw UnitError("has a decimal comma; write a point");
    std::string_view rest = text.substr(length);
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    const Unit unit = rest.empty() ? Unit{} : UnitParser(rest).parse();
    return {to_si(text.substr(0, length), unit), unit.dimension};
}

std::string to_text(double number) { return shifted_text(number, 0); }

std::string to_text(double si, std::string_view name) {
    if (name.empty()) return to_text(si);
    const Unit unit = UnitParser(name).parse();
    const bool power_of_ten =
        unit.numerator == 1 && unit.denominator == 1 && unit.irrational == 1.0;
    if (power_of_ten) return joined(shifted_text(si, unit.exponent), name);
    const std::string text = searched_text(si, unit, name);
    return text.empty() ? joined(to_text(si), si_unit(unit.dimension)) : text;
}

std::string to_text(double si, Dimension dimension) {
    const Customary* c = find_customary(dimension);
    if (c == nullptr) return joined(to_text(si), si_unit(dimension));
    for (const std::string_view unit : c->units) {
        if (unit.empty()) continue;
        const double value = std::abs(si / to_si("1", UnitParser(unit).parse()));
        if (value >= 0.1 && value < 1000.0) return to_text(si, unit);
    }
    return joined(to_text(si), c->units[0]);
}

std::string rounded_text(double si, Dimension dimension, int digits) {
    const std::string text = fmt::format("{:.{}e}", si, digits - 1);
    double rounded = si;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return to_text(rounded, dimension);
}

std::string dimension_name(Dimension dimension) {
    if (const Customary* c = find_customary(dimension)) return std::string(c->name);
    return si_unit(dimension);
}

std::string si_unit(Dimension d) {
    if (const Customary* c = find_customary(d)) return std::string(c->units[0]);
    std::string text;
    const auto append = [&](std::string_view name, int power) {
        if (power == 0) return;
        if (!text.empty()) text += ' ';
        text += name;
        if (power != 1) text += fmt::format("^{}", power);
    };
    append("kg", d.kg);
    append("m", d.m);
    append("s", d.s);
    append("rad", d.rad);
    return text;
}

}  // namespace tt
