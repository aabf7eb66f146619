#include "robot_app/deployment/report/pictures.h"

#include <algorithm>
#include <array>

#include "bt_core/engine/compile/models.h"

namespace coppice::robot::deployment {
namespace {

constexpr std::array<const char*, kActivities> kColours = {
    "#b7d7b0", "#4f9d4a", "#d98c1f", "#3b6fb6", "#e8c547", "#c2452d", "#333333"};
constexpr double kWidth = 1100;

// A number of a picture.
std::string N(double number) { return Printed("%.1f", number); }

std::string Rectangle(double x, double y, double width, double height, const char* colour) {
  return "<rect x='" + N(x) + "' y='" + N(y) + "' width='" + N(std::max(width, 0.3)) +
         "' height='" + N(height) + "' fill='" + colour + "'/>";
}

std::string Text(double x, double y, const std::string& text) {
  return "<text x='" + N(x) + "' y='" + N(y) + "'>" + EscapeXml(text) + "</text>";
}

std::string Circle(double x, double y, double radius, const char* colour, double opacity = 1) {
  return "<circle cx='" + N(x) + "' cy='" + N(y) + "' r='" + N(radius) + "' fill='" + colour +
         "' fill-opacity='" + N(opacity) + "'/>";
}

std::string Line(const std::vector<std::pair<double, double>>& points, const char* colour) {
  std::string text = "<polyline fill='none' stroke='" + std::string(colour) + "' points='";
  for (const auto& [x, y] : points) text += N(x) + "," + N(y) + " ";
  return text + "'/>";
}

std::string Picture(double width, double height, const std::string& inside) {
  return "<svg viewBox='0 0 " + N(width) + " " + N(height) + "' width='" + N(width) + "'>" +
         inside + "</svg>\n";
}

// Lifetimes in hours, and whether each ended in a stop.
std::vector<std::pair<double, bool>> LivesOf(const Group& group) {
  std::vector<std::pair<double, bool>> lives;
  for (const Figures& figures : group.figures) {
    const auto& hours = figures.lifetimes.hours;
    for (std::size_t i = 0; i < hours.size(); ++i)
      lives.emplace_back(hours[i], i + 1 < hours.size());
  }
  std::sort(lives.begin(), lives.end());
  return lives;
}

}  // namespace

std::string Legend() {
  std::string text = "<p>";
  for (int i = 0; i < kActivities; ++i) {
    text += std::string("<span style='background:") + kColours[static_cast<std::size_t>(i)] +
            "'>&nbsp;&nbsp;&nbsp;</span> " + ToString(static_cast<Activity>(i)) + " &nbsp; ";
  }
  return text + "&#9679; unplanned stop &nbsp; &#9650; request; below: the battery</p>\n";
}

std::string Timeline(const Journal& journal) {
  const double seconds = SecondsOf(journal.span);
  const auto x_of = [&](Time time) {
    return kWidth * SecondsOf({journal.span.from, time}) / seconds;
  };
  std::string inside;
  for (const Span& span : journal.spans) {
    const double x = x_of(span.when.from);
    inside += Rectangle(x, 4, x_of(span.when.to) - x, 16,
                        kColours[static_cast<std::size_t>(span.activity)]);
  }
  for (const Request& request : journal.requests) {
    const double x = x_of(request.asked);
    inside += Line({{x - 3, 3}, {x, 0}, {x + 3, 3}}, "#c2452d");
  }
  for (const UnplannedStop& stop : journal.stops) inside += Circle(x_of(stop.at), 12, 5, "#000000");
  std::vector<std::pair<double, double>> level;
  for (const BatterySample& sample : journal.battery) {
    level.emplace_back(x_of(sample.at), 44 - 20 * sample.level);
  }
  return Picture(kWidth, 46, inside + Line(level, "#555555"));
}

std::string MapOfRecoveries(const Group& group) {
  constexpr double kScale = 19, kLeft = 4, kTop = 7.5;  // pixels per metre; m
  std::string inside;
  for (const Journal& journal : group.journals) {
    for (const leaves::RecoveryEvent& event : journal.recoveries) {
      if (event.phase != leaves::RecoveryPhase::kBegun || !event.pose) continue;
      const bool is_lost = event.subject == "localization";
      inside += Circle(kScale * (event.pose->x + kLeft), kScale * (kTop - event.pose->y), 3,
                       is_lost ? "#3b6fb6" : "#c2452d", 0.3);
    }
  }
  return Picture(kWidth, kScale * 2 * kTop, inside);
}

std::vector<std::pair<double, double>> Survival(const Group& group) {
  const auto lives = LivesOf(group);
  std::vector<std::pair<double, double>> steps = {{0, 1}};
  double share = 1;
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const auto at_risk = static_cast<double>(lives.size() - i);
    if (lives[i].second) share *= 1 - 1 / at_risk;
    steps.emplace_back(lives[i].first, share);
  }
  return steps;
}

std::string SurvivalPicture(const std::vector<Group>& groups) {
  constexpr double kHours = 300, kHigh = 200, kLeft = 40;
  constexpr std::array<const char*, 8> kLines = {"#3b6fb6", "#c2452d", "#4f9d4a", "#d98c1f",
                                                 "#7a4fa3", "#777777", "#1fa6a6", "#a64d79"};
  std::string inside = Text(0, 14, "1") + Text(0, kHigh, "0") +
                       Line({{kLeft, 0}, {kLeft, kHigh}, {kWidth - 200, kHigh}}, "#999999");
  const double scale = (kWidth - 240) / kHours;
  for (int hours = 0; hours <= 300; hours += 50) {
    inside += Text(kLeft + scale * hours, kHigh + 16, std::to_string(hours) + " h");
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<std::pair<double, double>> points;
    double before = 1;
    for (const auto& [hours, share] : Survival(groups[i])) {
      points.emplace_back(kLeft + scale * hours, kHigh * (1 - before));
      points.emplace_back(kLeft + scale * hours, kHigh * (1 - share));
      before = share;
    }
    const char* const colour = kLines[i % kLines.size()];
    inside += Line(points, colour);
    const double y = 16 + 16 * static_cast<double>(i);
    inside += Rectangle(kWidth - 190, y - 9, 12, 9, colour) + Text(kWidth - 172, y, groups[i].name);
  }
  return Picture(kWidth, kHigh + 22, inside);
}

}  // namespace coppice::robot::deployment
