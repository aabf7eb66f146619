#include "robot_app/deployment/report/report.h"

#include <algorithm>
#include <filesystem>

#include "bt_core/engine/compile/models.h"
#include "robot_app/deployment/figures/journal_file.h"
#include "robot_app/deployment/report/pictures.h"

namespace coppice::robot::deployment {
namespace {

namespace fs = std::filesystem;

constexpr char kStyle[] =
    "<style>body{font:14px sans-serif;max-width:1120px;margin:2em auto}table{border-collapse:"
    "collapse}td,th{border:1px solid #ccc;padding:3px 8px;text-align:left}svg{display:block;"
    "margin:2px 0;font:11px sans-serif}h3{margin-bottom:0}</style>";

// What is compared with the paper: ours and the published one, as they are.
std::vector<Group> Compared(const std::vector<Group>& groups) {
  std::vector<Group> compared;
  for (const Group& group : groups) {
    if (group.name == "ours" || group.name == "published") compared.push_back(group);
  }
  return compared.empty() ? groups : compared;
}

std::vector<Table> TablesOf(const std::vector<Group>& groups) {
  const std::vector<Group> compared = Compared(groups);
  std::vector<Table> tables = {MetricsTable(compared), RecoveriesTable(compared)};
  for (const Group& group : groups) {
    if (group.name == "published") tables.push_back(ValidationTable(group));
  }
  tables.push_back(StopsTable(compared));
  tables.push_back(ComparisonTable(groups));
  return tables;
}

Table NumbersTable(const Scenario& scenario) {
  Table table;
  table.title = "The numbers of the world";
  table.head = {"number", "value", "unit", "source"};
  for (const SourcedNumber& number : scenario.numbers) {
    table.rows.push_back({number.name, Printed("%g", number.value), number.unit, number.source});
  }
  return table;
}

std::string SeedOf(const Journal& journal) {
  std::string text = "<h3>" + EscapeXml(journal.controller) + ", seed " +
                     std::to_string(journal.seed) + ": " + std::to_string(journal.stops.size()) +
                     " unplanned stops, " + std::to_string(journal.requests.size()) +
                     " requests</h3>\n" + Timeline(journal);
  for (const UnplannedStop& stop : journal.stops) {
    text +=
        "<div>" + MomentText(stop.at) + " " + EscapeXml(stop.cause + ": " + stop.what) + "</div>\n";
  }
  for (const std::string& record : journal.records) {
    const std::string link = EscapeXml(journal.controller + "/" + record);
    text += "<div><a href=\"./" + link + "\">" + link + "</a></div>\n";
  }
  return text;
}

}  // namespace

Expected<std::vector<Journal>> LoadJournals(const std::vector<std::string>& folders) {
  std::vector<std::string> files;
  for (const std::string& folder : folders) {
    std::error_code error;
    for (auto entry = fs::recursive_directory_iterator(folder, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      const bool is_run = name.rfind("seed-", 0) == 0 && entry->path().extension() == ".json";
      if (is_run) files.push_back(entry->path().string());
    }
    if (error) return Problem{folder + ": " + error.message()};
  }
  if (files.empty()) return Problem{"there are no runs in these folders"};
  std::sort(files.begin(), files.end());
  std::vector<Journal> journals;
  for (const std::string& file : files) {
    auto journal = LoadJournal(file);
    if (!journal) return Problem{journal.problem()};
    journals.push_back(*std::move(journal));
  }
  return journals;
}

std::string MarkdownReport(const std::vector<Group>& groups) {
  std::string text = "# Sixteen days\n\n";
  for (const Table& table : TablesOf(groups)) text += ToMarkdown(table);
  return text;
}

std::string HtmlReport(const std::vector<Group>& groups, const Scenario& scenario) {
  std::string text = "<!doctype html><meta charset='utf-8'><title>Sixteen days</title>" +
                     std::string(kStyle) + "<h1>Sixteen days</h1>\n";
  for (const Table& table : TablesOf(groups)) text += ToHtml(table);
  text += "<h2>Time between unplanned stops (Kaplan–Meier)</h2>\n" + SurvivalPicture(groups);
  text += "<h2>Where it recovered</h2><p>red: navigation and programs, blue: localization</p>\n";
  for (const Group& group : Compared(groups)) {
    text += "<h3>" + EscapeXml(group.name) + "</h3>\n" + MapOfRecoveries(group);
  }
  text += "<h2>Day by day</h2>\n" + Legend();
  for (const Group& group : Compared(groups)) {
    for (const Journal& journal : group.journals) text += SeedOf(journal);
  }
  return text + ToHtml(NumbersTable(scenario));
}

}  // namespace coppice::robot::deployment
