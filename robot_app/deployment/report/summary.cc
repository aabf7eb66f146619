#include "robot_app/deployment/report/summary.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "robot_app/deployment/report/published.h"

namespace coppice::robot::deployment {
namespace {

constexpr PublishedMetrics kPaper;

using FigureOf = std::function<double(const Journal&, const Figures&)>;

std::string NameOf(const Journal& journal) {
  std::string name = journal.controller;
  if (journal.times != 1) name += ", faults x " + Printed("%g", journal.times);
  for (const std::string& fault : journal.without) name += ", without " + fault;
  return name;
}

int RankOf(const std::string& name) { return name == "ours" ? 0 : name == "published" ? 1 : 2; }

double PerDay(double hours, const Figures& figures) {
  return figures.working_days == 0 ? 0 : hours / figures.working_days;
}

const RecoveryRow* RowOf(const Figures& figures, const std::string& recovery) {
  const auto found = std::find_if(figures.recoveries.begin(), figures.recoveries.end(),
                                  [&](const RecoveryRow& row) { return row.recovery == recovery; });
  return found == figures.recoveries.end() ? nullptr : &*found;
}

// "5.9 (5.2 - 6.3)": the mean, and the least and the most of the seeds.
std::string MeanAndRange(const Group& group, const char* format, const FigureOf& of) {
  double least = 1e300, most = -1e300;
  for (std::size_t i = 0; i < group.journals.size(); ++i) {
    const double figure = of(group.journals[i], group.figures[i]);
    least = std::min(least, figure);
    most = std::max(most, figure);
  }
  return Printed(format, MeanOf(group, of)) + " (" + Printed(format, least) + " – " +
         Printed(format, most) + ")";
}

std::vector<std::string> HeadOf(std::vector<std::string> head, const std::vector<Group>& groups) {
  for (const Group& group : groups) {
    head.push_back(group.name + " (" + std::to_string(group.journals.size()) + ")");
  }
  return head;
}

struct Metric {
  const char* name;
  std::string paper;
  const char* format;
  FigureOf of;
};

std::vector<Metric> Metrics() {
  const auto days = [](const Journal&, const Figures& f) { return f.working_days; };
  return {
      {"working days", "12", "%.0f", days},
      {"off the station a day [h]", Printed("%.1f", kPaper.operating), "%.2f",
       [](const Journal&, const Figures& f) { return PerDay(f.undocked, f); }},
      {"in motion a day [h]", Printed("%.1f", kPaper.moving), "%.2f",
       [](const Journal&, const Figures& f) { return PerDay(f.moving, f); }},
      {"A% = in motion / 8 h", Printed("%.0f", kPaper.autonomy), "%.1f",
       [](const Journal&, const Figures& f) { return f.autonomy(); }},
      {"A% by gaps of the feedback", "", "%.1f",
       [](const Journal&, const Figures& f) { return f.autonomy_by_gaps(); }},
      {"distance [km]", Printed("%.1f", kPaper.distance), "%.1f",
       [](const Journal&, const Figures& f) { return f.distance; }},
      {"mean TSL [h]", Printed("%.1f", kPaper.mean_tsl), "%.1f",
       [](const Journal&, const Figures& f) { return f.lifetimes.mean(); }},
      {"max TSL [h]", Printed("%.1f", kPaper.max_tsl), "%.1f",
       [](const Journal&, const Figures& f) { return f.lifetimes.most(); }},
      {"unplanned stops", std::to_string(kPaper.stops), "%.2f",
       [](const Journal&, const Figures& f) { return f.stops; }},
      {"requests to supervisors", std::to_string(kPaper.requests), "%.2f",
       [](const Journal&, const Figures& f) { return f.requests; }},
      {"minutes to the answer", "", "%.1f",
       [](const Journal&, const Figures& f) { return f.answer_minutes; }},
      {"visits of the station", std::to_string(kPaper.dockings), "%.1f",
       [](const Journal&, const Figures& f) { return f.docking_episodes; }},
      {"of these with current [%]", Printed("%.1f", 100.0 * kPaper.good_dockings / kPaper.dockings),
       "%.1f",
       [](const Journal&, const Figures& f) {
         return f.docking_episodes == 0 ? 100
                                        : 100.0 * f.good_docking_episodes / f.docking_episodes;
       }},
      {"charging on duty a day [h]", Printed("%.1f", kPaper.extra_charging), "%.2f",
       [](const Journal&, const Figures& f) { return PerDay(f.extra_charging, f); }},
      {"faces with mask", std::to_string(kPaper.with_mask), "%.0f",
       [](const Journal& j, const Figures&) { return j.with_mask; }},
      {"faces without", std::to_string(kPaper.without_mask), "%.0f",
       [](const Journal& j, const Figures&) { return j.without_mask; }},
  };
}

// "181 (72.1 %, 69.0 %)" a seed: helped by the paper's words, and strictly.
std::string RecoveryCell(const Group& group, const PublishedRecovery& row) {
  double count = 0, helped = 0, strictly = 0;
  for (std::size_t i = 0; i < group.journals.size(); ++i) {
    if (row.subject) {
      for (const Request& request : group.journals[i].requests) {
        if (request.subject != row.subject) continue;
        ++count;
        helped += request.is_fixed;
        strictly += request.is_fixed;
      }
    } else if (const RecoveryRow* found = RowOf(group.figures[i], row.recovery)) {
      count += found->count;
      helped += found->helped;
      strictly += found->helped_strictly;
    }
  }
  if (count == 0) return "0";
  return Printed("%.1f", count / static_cast<double>(group.journals.size())) + " (" +
         Printed("%.1f", 100 * helped / count) + " %, " + Printed("%.1f", 100 * strictly / count) +
         " %)";
}

}  // namespace

std::vector<Group> GroupsOf(std::vector<Journal> journals) {
  std::map<std::pair<int, std::string>, Group> groups;
  std::sort(journals.begin(), journals.end(),
            [](const Journal& a, const Journal& b) { return a.seed < b.seed; });
  for (Journal& journal : journals) {
    const std::string name = NameOf(journal);
    Group& group = groups[{RankOf(name), name}];
    group.name = name;
    group.figures.push_back(FiguresOf(journal));
    group.journals.push_back(std::move(journal));
  }
  std::vector<Group> sorted;
  for (auto& [key, group] : groups) sorted.push_back(std::move(group));
  return sorted;
}

int CountOf(const Journal& journal, const Figures& figures, const std::string& recovery,
            const char* subject) {
  if (subject) {
    return static_cast<int>(
        std::count_if(journal.requests.begin(), journal.requests.end(),
                      [&](const Request& request) { return request.subject == subject; }));
  }
  const RecoveryRow* const row = RowOf(figures, recovery);
  return row ? row->count : 0;
}

double MeanOf(const Group& group, const FigureOf& of) {
  double sum = 0;
  for (std::size_t i = 0; i < group.journals.size(); ++i) {
    sum += of(group.journals[i], group.figures[i]);
  }
  return group.journals.empty() ? 0 : sum / static_cast<double>(group.journals.size());
}

Table MetricsTable(const std::vector<Group>& groups) {
  Table table;
  table.title = "Table II: metrics of a deployment";
  table.head = HeadOf({"metric", "paper"}, groups);
  for (const Metric& metric : Metrics()) {
    std::vector<std::string> row = {metric.name, metric.paper};
    for (const Group& group : groups) {
      row.push_back(MeanAndRange(group, metric.format, metric.of));
    }
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Mean of the seeds (in brackets behind the controller), and the least and the most "
      "of them.";
  return table;
}

Table RecoveriesTable(const std::vector<Group>& groups) {
  Table table;
  table.title = "Table III: recoveries of a deployment";
  table.head = HeadOf({"type", "reaction", "paper"}, groups);
  for (const PublishedRecovery& paper : kPublishedRecoveries) {
    std::vector<std::string> row = {paper.type, paper.reaction,
                                    std::to_string(paper.count) + " (" +
                                        Printed("%.1f", 100.0 * paper.helped / paper.count) +
                                        " %)"};
    for (const Group& group : groups) row.push_back(RecoveryCell(group, paper));
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Mean number in a deployment, and the share that helped: no further one within a "
      "minute (and a metre), and, as the scripts count, none within a minute or a metre.";
  return table;
}

Table ValidationTable(const Group& group) {
  Table table;
  table.title = "Is \"" + group.name + "\" the published robot?";
  table.head = {"figure", "paper", "95 % interval", "mean", "mean within", "seeds within"};
  const auto add = [&](const std::string& name, double paper, Bounds bounds, const FigureOf& of) {
    int within = 0;
    for (std::size_t i = 0; i < group.journals.size(); ++i) {
      within += bounds.Contains(of(group.journals[i], group.figures[i]));
    }
    const double mean = MeanOf(group, of);
    table.rows.push_back({name, Printed("%g", paper),
                          Printed("%g", bounds.low) + " – " + Printed("%g", bounds.high),
                          Printed("%.1f", mean), bounds.Contains(mean) ? "yes" : "NO",
                          std::to_string(within) + " of " + std::to_string(group.journals.size())});
  };
  for (const PublishedRecovery& row : kPublishedRecoveries) {
    add(row.reaction, row.count, CountsOfMean(row.count), [&](const Journal& j, const Figures& f) {
      return CountOf(j, f, row.recovery, row.subject);
    });
  }
  add("requests to supervisors", kPaper.requests, CountsOfMean(kPaper.requests),
      [](const Journal&, const Figures& f) { return f.requests; });
  add("unplanned stops", kPaper.stops, CountsOfMean(kPaper.stops),
      [](const Journal&, const Figures& f) { return f.stops; });
  add("dockings", kPaper.dockings, {24, 32},
      [](const Journal&, const Figures& f) { return f.docking_episodes; });
  add("distance [km]", kPaper.distance, {0.9 * kPaper.distance, 1.1 * kPaper.distance},
      [](const Journal&, const Figures& f) { return f.distance; });
  add("A%", kPaper.autonomy, {65, 72},
      [](const Journal&, const Figures& f) { return f.autonomy(); });
  table.note = "By chance alone about one seed of twenty lies outside of an interval.";
  return table;
}

Table StopsTable(const std::vector<Group>& groups) {
  std::set<std::string> causes;
  for (const Group& group : groups) {
    for (const Journal& journal : group.journals) {
      for (const UnplannedStop& stop : journal.stops) causes.insert(stop.cause);
    }
  }
  Table table;
  table.title = "Unplanned stops by cause";
  table.head = HeadOf({"cause"}, groups);
  for (const std::string& cause : causes) {
    std::vector<std::string> row = {cause};
    for (const Group& group : groups) {
      int count = 0, seeds = 0;
      for (const Journal& journal : group.journals) {
        const auto in_seed =
            std::count_if(journal.stops.begin(), journal.stops.end(),
                          [&](const UnplannedStop& stop) { return stop.cause == cause; });
        count += static_cast<int>(in_seed);
        seeds += in_seed > 0;
      }
      row.push_back(std::to_string(count) + " in " + std::to_string(seeds) + " seeds");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table ComparisonTable(const std::vector<Group>& groups) {
  Table table;
  table.title = "What buys what";
  table.head = {"controller",    "seeds",        "without a stop", "stops", "undocked [h]",
                "MTBF [h] 95 %", "mean TSL [h]", "requests",       "A%",    "docked [%]"};
  for (const Group& group : groups) {
    int stops = 0, clean = 0, visits = 0, good = 0;
    double undocked = 0, life = 0;
    for (const Figures& figures : group.figures) {
      stops += figures.stops;
      clean += figures.stops == 0;
      undocked += figures.undocked;
      life += figures.lifetimes.sum();
      visits += figures.docking_episodes;
      good += figures.good_docking_episodes;
    }
    const Bounds bounds = MeanOfCount(stops);
    table.rows.push_back(
        {group.name, std::to_string(group.journals.size()), std::to_string(clean),
         std::to_string(stops), Printed("%.0f", undocked),
         Printed("%.0f", life / bounds.high) + " – " +
             (stops == 0 ? "∞" : Printed("%.0f", life / bounds.low)),
         Printed("%.1f", MeanOf(group, [](const Journal&,
                                          const Figures& f) { return f.lifetimes.mean(); })),
         Printed("%.1f",
                 MeanOf(group, [](const Journal&, const Figures& f) { return f.requests; })),
         Printed("%.1f",
                 MeanOf(group, [](const Journal&, const Figures& f) { return f.autonomy(); })),
         Printed("%.2f", visits == 0 ? 100 : 100.0 * good / visits)});
  }
  table.note = "MTBF: all lifetimes over all unplanned stops, without weekends.";
  return table;
}

}  // namespace coppice::robot::deployment
