// What the contract suite found out about a pass.
#pragma once

#include <string>
#include <vector>

namespace passgraph::tool::contract {

/// One broken promise: where, what came out, what should have.
struct Finding {
    std::string check;
    std::string settings; ///< "sigma=20 taps=25"; "" at the defaults
    std::string fed;      ///< what the inputs held: "random values, NaN in `image` at (8, 6)"
    std::string place;    ///< "`color` at (3, 4) of 17x13"
    std::string got;
    std::string expected;
    std::string hint;
};

/// A named check of one pass, over all its runs.
struct CheckLine {
    std::string check;
    int runs = 0;
    int faults = 0;
    std::vector<Finding> findings; ///< the first few of the faults
};

struct PassReport {
    std::string pass;
    std::string file;
    std::vector<CheckLine> lines;

    bool is_sound() const
    {
        for (const CheckLine& line : lines)
            if (line.faults > 0)
                return false;
        return true;
    }
};

/// Collects a pass's lines; the order of first use is kept.
class Findings {
public:
    explicit Findings(PassReport& report) : report_(report) {}

    void count_run(const std::string& check) { ++line(check).runs; }
    void add(Finding finding)
    {
        CheckLine& into = line(finding.check);
        ++into.faults;
        if (into.findings.size() < kShown)
            into.findings.push_back(std::move(finding));
    }
    /// More of the same tells nothing new, and a broken pass would fill pages.
    bool is_full(const std::string& check) { return line(check).findings.size() >= kShown; }

private:
    static constexpr size_t kShown = 3;

    CheckLine& line(const std::string& check)
    {
        for (CheckLine& known : report_.lines)
            if (known.check == check)
                return known;
        report_.lines.push_back({check, 0, 0, {}});
        return report_.lines.back();
    }

    PassReport& report_;
};

} // namespace passgraph::tool::contract
