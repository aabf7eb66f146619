#include "tests/bench/table.h"

#include <cstdio>

namespace coppice::bench {
namespace {

// "-" for nothing; without a fraction where it says nothing.
std::string Number(std::optional<double> value) {
  if (!value) return "-";
  char text[32];
  const bool whole = *value >= 1000 || *value == static_cast<double>(static_cast<long>(*value));
  std::snprintf(text, sizeof(text), whole ? "%.0f" : "%.1f", *value);
  return text;
}

void PrintLine(const std::string& name, const std::string& measured, const std::string& limit,
               const std::string& peer, const std::string& unit, const std::string& verdict) {
  std::printf("%-30s %10s %10s %12s  %-28s %s\n", name.c_str(), measured.c_str(), limit.c_str(),
              peer.c_str(), unit.c_str(), verdict.c_str());
  std::fflush(stdout);
}

}  // namespace

Table::Table() { PrintLine("", "measured", "limit", "peer", "", ""); }

void Table::Add(const Row& row) {
  const bool above = row.limit && row.measured > *row.limit;
  above_limit_ += above;
  PrintLine(row.name, Number(row.measured), Number(row.limit), Number(row.peer), row.unit,
            above       ? "ABOVE"
            : row.limit ? "ok"
                        : "");
}

}  // namespace coppice::bench
