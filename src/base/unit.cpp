#include "base/unit.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "base/letter.hpp"
#include "base/units.hpp"
#include "base/words.hpp"

namespace tt {
namespace {

struct Symbol {
    std::string_view name;
    Unit unit;
    enum { plain, takes_prefix } kind = plain;
};

constexpr double degree = 3.14159265358979323846 / 180.0;

/// mmHg is the conventional millimetre of mercury, 133.322387415 Pa (BIPM, SI Brochure, 8th ed.,
/// table 8), mH2O the conventional metre of water, 9806.65 Pa (NIST SP 811, appendix B.8). eV and
/// the Boltzmann constant, 1.380649e-23 J/K, are exact (SI Brochure, 9th ed.); kT is at 310 K, the
/// temperature of the body.
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
    Symbol{"eV", {{1, 2, -2}, -28, 1602176634}, Symbol::takes_prefix},
    Symbol{"kT", {{1, 2, -2}, -28, 42800119}},
    Symbol{"kBT", {{1, 2, -2}, -28, 42800119}},
    Symbol{"Pa", {{1, -1, -2}}, Symbol::takes_prefix},
    Symbol{"bar", {{1, -1, -2}, 5}, Symbol::takes_prefix},
    Symbol{"mmHg", {{1, -1, -2}, -9, 133322387415}},
    Symbol{"mH2O", {{1, -1, -2}, -2, 980665}, Symbol::takes_prefix},
    Symbol{"atm", {{1, -1, -2}, 0, 101325}},
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
constexpr std::array prefixes{Prefix{'z', -21}, Prefix{'a', -18}, Prefix{'f', -15},
                              Prefix{'p', -12}, Prefix{'n', -9},  Prefix{'u', -6},
                              Prefix{'m', -3},  Prefix{'c', -2},  Prefix{'d', -1},
                              Prefix{'k', 3},   Prefix{'M', 6},   Prefix{'G', 9}};

/// What people write for a unit that has another symbol here.
struct Alias {
    std::string_view name;
    std::string_view symbol;
};
constexpr std::array aliases{
    Alias{"micron", "um"},     Alias{"microns", "um"}, Alias{"mum", "um"},
    Alias{"mu", "um"},         Alias{"sec", "s"},      Alias{"second", "s"},
    Alias{"seconds", "s"},     Alias{"msec", "ms"},    Alias{"usec", "us"},
    Alias{"mPas", "mPa s"},    Alias{"Pas", "Pa s"},   Alias{"poise", "P"},
    Alias{"dyne", "dyn"},      Alias{"dynes", "dyn"},  Alias{"cp", "cP"},
    Alias{"percent", "%"},     Alias{"degree", "deg"}, Alias{"degrees", "deg"},
    Alias{"hour", "h"},        Alias{"l", "L"},        Alias{"k_BT", "kT"},
    Alias{"kbT", "kT"},        Alias{"ev", "eV"},      Alias{"Torr", "mmHg"},
    Alias{"centipoise", "cP"}, Alias{"torr", "mmHg"},  Alias{"ml", "mL"},
    Alias{"ul", "uL"},         Alias{"nl", "nL"},
};

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

/// Recursive descent over: unit = ["/"] factor { ("*" | "." | " " | "/") factor }; factor = symbol
/// [["^"] power] | "(" unit ")".
class UnitParser {
public:
    explicit UnitParser(std::string_view text) : text_(text) {}

    Unit parse() {
        const Unit u = parse_product(0);
        if (position_ < text_.size()) tell_unexpected();
        return u;
    }

private:
    [[noreturn]] void tell_unexpected() const {
        const std::string_view rest = text_.substr(position_);
        const Letter letter = first_letter(rest);
        const std::string_view write = instead_of(letter.code);
        throw UnitError(fmt::format("'{}' is not expected in a unit{}{}",
                                    readable(rest.substr(0, letter.bytes)),
                                    write.empty() ? "" : "; write ", write));
    }

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
                (text_[position_] == '/' || (is_product(text_[position_]) && !first))) {
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
        // Of all symbols one holds a digit: mmH2O, cmH2O.
        if (position_ > begin && text_[position_ - 1] == 'H' && text_.substr(position_, 2) == "2O")
            position_ += 2;
        const std::string_view name = text_.substr(begin, position_ - begin);
        if (name.empty() && position_ < text_.size()) tell_unexpected();
        if (name.empty()) throw UnitError("a unit is missing at the end");
        if (const auto unit = find_unit(name)) return *unit;
        throw UnitError(unknown_unit(name));
    }

    static bool is_letter(char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    }
    static bool is_product(char c) { return c == '*' || c == '.'; }
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }

    /// "m3", "s-1": without a '^'.
    static bool begins_power(std::string_view text) {
        if (text.size() > 1 && text[0] == '-') return is_digit(text[1]);
        return !text.empty() && text[0] >= '2' && text[0] <= '9';
    }

    int parse_power() {
        std::size_t p = position_;
        if (p < text_.size() && text_[p] == '^')
            ++p;
        else if (!begins_power(text_.substr(p)))
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

}  // namespace

Unit parse_unit(std::string_view text) { return UnitParser(text).parse(); }

}  // namespace tt
