#include "bt_core/cli/test/random_report.h"

#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace coppice {
namespace {

std::string Summary(const Coverage& coverage) {
  const auto of = [&](Status status) { return coverage.results[static_cast<std::size_t>(status)]; };
  std::string text = std::to_string(coverage.runs) + " runs, seeds " +
                     std::to_string(coverage.first_seed) + " to " +
                     std::to_string(coverage.first_seed + coverage.runs - 1) + ", " +
                     std::to_string(coverage.ticks) + " ticks: ";
  text += std::to_string(of(Status::kSuccess)) + " SUCCESS, ";
  text += std::to_string(of(Status::kFailure)) + " FAILURE, ";
  if (of(Status::kSkipped) > 0) text += std::to_string(of(Status::kSkipped)) + " SKIPPED, ";
  return text + std::to_string(of(Status::kRunning)) + " broken off\n";
}

std::string Line(const NodeCoverage& node) {
  char text[128];
  std::snprintf(text, sizeof(text),
                "%10" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 "  ",
                node.ticks(), node.results_of(Status::kSuccess), node.results_of(Status::kFailure),
                node.results_of(Status::kSkipped), node.results_of(Status::kRunning),
                node.results_of(Status::kIdle));
  return text + node.path + "\n";
}

std::string List(const char* title, const std::vector<std::string>& paths) {
  std::string text = std::string(title) + ": " + (paths.empty() ? "none" : "") + "\n";
  for (const std::string& path : paths) text += "  " + path + "\n";
  return text;
}

std::string Describe(const RandomFinding& finding) {
  return "  " + (finding.node.empty() ? "the tree" : finding.node) + ": " + finding.text +
         "\n    " + std::to_string(finding.times) + " times, first in tick " +
         std::to_string(finding.tick) + " of --seed " + std::to_string(finding.seed) + "\n";
}

}  // namespace

std::string CoverageText(const Coverage& coverage) {
  std::string text = Summary(coverage);
  text += "     ticks   SUCCESS   FAILURE   SKIPPED   RUNNING    halted  node\n";
  for (const NodeCoverage& node : coverage.nodes) text += Line(node);
  text += List("never ticked", NeverTicked(coverage));
  text += List("ticked, but never SUCCESS", NeverReturned(coverage, Status::kSuccess));
  text += List("ticked, but never FAILURE", NeverReturned(coverage, Status::kFailure));
  if (!coverage.findings.empty()) text += "found:\n";
  for (const RandomFinding& finding : coverage.findings) text += Describe(finding);
  return text;
}

std::string CoverageJson(const Coverage& coverage) {
  using Json = nlohmann::ordered_json;
  const auto results = [](const std::array<std::uint64_t, 5>& of, const char* idle) {
    const auto at = [&](Status status) { return of[static_cast<std::size_t>(status)]; };
    Json json = {{"SUCCESS", at(Status::kSuccess)},
                 {"FAILURE", at(Status::kFailure)},
                 {"SKIPPED", at(Status::kSkipped)},
                 {"RUNNING", at(Status::kRunning)}};
    if (idle) json[idle] = at(Status::kIdle);
    return json;
  };
  Json json = {{"seed", coverage.first_seed},
               {"runs", coverage.runs},
               {"ticks", coverage.ticks},
               {"results", results(coverage.results, nullptr)},
               {"nodes", Json::array()},
               {"never_ticked", NeverTicked(coverage)},
               {"never_success", NeverReturned(coverage, Status::kSuccess)},
               {"never_failure", NeverReturned(coverage, Status::kFailure)},
               {"findings", Json::array()}};
  for (const NodeCoverage& node : coverage.nodes) {
    Json entry = {{"path", node.path}, {"ticks", node.ticks()}};
    entry.update(results(node.results, "halted"));
    json["nodes"].push_back(std::move(entry));
  }
  for (const RandomFinding& finding : coverage.findings) {
    json["findings"].push_back({{"node", finding.node},
                                {"text", finding.text},
                                {"times", finding.times},
                                {"seed", finding.seed},
                                {"tick", finding.tick}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace coppice
