#include "robot_app/questionnaire/figures.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace coppice::robot::questionnaire {
namespace {

// Of a sample: divided by one less than there are.
double Variance(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / (count - 1);
}

std::string Text(const std::optional<double>& number, const char* format) {
  if (!number) return "-";
  char text[32];
  std::snprintf(text, sizeof(text), format, *number);
  return text;
}

std::string MediansText(const std::vector<std::optional<double>>& medians) {
  std::string text;
  for (const auto& median : medians) text += (text.empty() ? "" : " ") + Text(median, "%g");
  return text.empty() ? "-" : text;
}

// The marks of one scale: those of all who have marked each of its items.
std::vector<std::vector<double>> WholeRows(const std::vector<Marks>& people, std::size_t first,
                                           std::size_t count) {
  std::vector<std::vector<double>> rows;
  for (const Marks& marks : people) {
    const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<double> row(begin, begin + static_cast<std::ptrdiff_t>(count));
    if (std::count(row.begin(), row.end(), 0.0) == 0) rows.push_back(row);
  }
  return rows;
}

std::optional<double> MedianOfItem(const std::vector<Marks>& people, std::size_t column) {
  std::vector<double> marks;
  for (const Marks& person : people) {
    if (person[column] != 0) marks.push_back(person[column]);
  }
  return Median(std::move(marks));
}

}  // namespace

std::optional<double> Median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::optional<double> CronbachAlpha(const std::vector<std::vector<double>>& rows) {
  if (rows.size() < 2 || rows[0].size() < 2) return std::nullopt;
  const std::size_t items = rows[0].size();
  std::vector<double> sums;
  for (const auto& row : rows) sums.push_back(std::accumulate(row.begin(), row.end(), 0.0));
  double of_items = 0;
  for (std::size_t item = 0; item < items; ++item) {
    std::vector<double> column;
    for (const auto& row : rows) column.push_back(row[item]);
    of_items += Variance(column);
  }
  const double of_sums = Variance(sums);
  if (of_sums <= 0) return std::nullopt;
  const double k = static_cast<double>(items);
  return k / (k - 1) * (1 - of_items / of_sums);
}

std::string FiguresText(const Questionnaire& questionnaire, const std::vector<Marks>& people) {
  std::string text = std::to_string(people.size()) + " people\n";
  char line[256];
  std::snprintf(line, sizeof(line), "%-24s %6s %6s  %-20s %s\n", "scale", "alpha", "paper",
                "medians", "paper");
  text += line;
  std::size_t column = 0;
  for (const Scale& scale : questionnaire.scales) {
    const auto alpha = CronbachAlpha(WholeRows(people, column, scale.items.size()));
    std::vector<std::optional<double>> medians;
    for (std::size_t i = 0; i < scale.items.size(); ++i) {
      medians.push_back(MedianOfItem(people, column++));
    }
    const std::vector<std::optional<double>> paper(scale.paper_medians.begin(),
                                                   scale.paper_medians.end());
    std::snprintf(line, sizeof(line), "%-24s %6s %6s  %-20s %s\n", scale.name[0].c_str(),
                  Text(alpha, "%.2f").c_str(), Text(scale.paper_alpha, "%.2f").c_str(),
                  MediansText(medians).c_str(), MediansText(paper).c_str());
    text += line;
  }
  return text;
}

}  // namespace coppice::robot::questionnaire
