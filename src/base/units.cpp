#include "base/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include "base/unit.hpp"

namespace tt {
namespace {

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
    Customary{{1, 0, -1}, "viscosity of a membrane", {"N s/m", "uN s/m", "nN s/m"}},
    Customary{{1, 2, -1}, "viscosity of bending", {"N m s"}},
    Customary{{1, 1, -3}, "power per depth", {"W/m", "mW/m", "uW/m", "nW/m", "pW/m"}},
};

const Customary* find_customary(Dimension dimension) {
    for (const Customary& c : customary)
        if (c.dimension == dimension) return &c;
    return nullptr;
}

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
    const Unit unit = rest.empty() ? Unit{} : parse_unit(rest);
    return {to_si(text.substr(0, length), unit), unit.dimension};
}

std::string to_text(double number) { return shifted_text(number, 0); }

std::string to_text(double si, std::string_view name) {
    if (name.empty()) return to_text(si);
    const Unit unit = parse_unit(name);
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
        const double value = std::abs(si / to_si("1", parse_unit(unit)));
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
