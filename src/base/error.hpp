#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/undefined.hpp"

namespace tt {

/// One thing wrong in what the user wrote, with what to write instead. line 0: not tied to a line.
struct Fault {
    std::string file;
    int line = 0;
    int column = 0;
    std::string message;
};

/// `file:line:column: message`, the form editors and people know.
std::string to_string(const Fault& fault);

/// The user's input is at fault (exit 2). Carries every fault at once.
class CaseError : public std::runtime_error {
public:
    explicit CaseError(std::vector<Fault> faults);
    const std::vector<Fault>& faults() const { return faults_; }

private:
    std::vector<Fault> faults_;
};

/// A file or directory cannot be read or written (exit 5). The message names the path and the
/// cause.
class IoError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The results directory belongs to another run or another case (exit 4).
class DirectoryInUse : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A stop was asked for before there was anything to go on from (exit 75).
class StoppedEarly : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a guard saw. cell and node are -1 where they do not apply; values are in the stated unit.
struct Instability {
    std::string quantity;  ///< e.g. "node step"
    double value = 0.0;
    double limit = 0.0;
    std::string unit;  ///< e.g. "sites"
    long long step = 0;
    double time = 0.0;  ///< [s]
    int cell = -1;
    int node = -1;
    double x = undefined;  ///< place in the box [m]; nan: everywhere
    double y = undefined;
    std::string cause;  ///< likely cause
    std::string cure;   ///< what to change
};

/// One line of a message under its first: "  label: text", broken at 80 columns.
std::string labelled(const std::string& label, const std::string& text);

/// The simulation left what it can compute (exit 3). The message says what was seen, where, why,
/// and then `more`, lines of its own.
class SimulationError : public std::runtime_error {
public:
    explicit SimulationError(Instability what, const std::string& more = {});
    const Instability& instability() const { return what_; }

private:
    Instability what_;
};

}  // namespace tt
