#include "bt_core/analysis/compare.h"

#include <algorithm>
#include <map>

#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

// A node or key of both runs, or of one of them.
using ThingNumber = std::size_t;

// The nodes and keys of both trees by name.
class Things {
 public:
  Things(const TreeDescription& first, const TreeDescription& second) {
    Add(first, first_nodes, first_slots);
    const std::size_t of_first = names.size();
    Add(second, second_nodes, second_slots);
    is_of_first.assign(names.size(), false);
    std::fill_n(is_of_first.begin(), of_first, true);
    is_of_second.assign(names.size(), false);
    for (const ThingNumber thing : second_nodes) is_of_second[thing] = true;
    for (const ThingNumber thing : second_slots) is_of_second[thing] = true;
  }

  bool are_of_both(ThingNumber thing) const { return is_of_first[thing] && is_of_second[thing]; }

  std::vector<std::string> names;
  std::vector<bool> is_node;
  std::vector<bool> is_of_first;
  std::vector<bool> is_of_second;
  std::vector<ThingNumber> first_nodes;
  std::vector<ThingNumber> first_slots;
  std::vector<ThingNumber> second_nodes;
  std::vector<ThingNumber> second_slots;

 private:
  void Add(const TreeDescription& tree, std::vector<ThingNumber>& nodes,
           std::vector<ThingNumber>& slots) {
    for (const DescribedNode& node : tree.nodes) nodes.push_back(NumberOf(node.path, true));
    for (const DescribedSlot& slot : tree.slots) {
      slots.push_back(
          NumberOf(slot.has_key ? slot.scope + "{" + slot.name + "}" : slot.name, false));
    }
  }

  ThingNumber NumberOf(const std::string& name, bool node) {
    const auto [at, is_new] = numbers_.emplace(std::make_pair(!node, name), names.size());
    if (is_new) {
      names.push_back(name);
      is_node.push_back(node);
    }
    return at->second;
  }

  std::map<std::pair<bool, std::string>, ThingNumber> numbers_;
};

// One thing that happened in a tick.
struct Deed {
  ThingNumber thing;
  std::string what;
};

std::vector<Deed> DeedsIn(EventWords words, const std::vector<ThingNumber>& nodes,
                          const std::vector<ThingNumber>& slots) {
  std::vector<Deed> deeds;
  EventReader reader(words);
  for (Event event; reader.Next(event);) {
    if (event.is_result() && event.index < nodes.size()) {
      deeds.push_back({nodes[event.index], ToString(event.status())});
    } else if (event.code == EventCode::kWrite || event.code == EventCode::kDelivery) {
      if (event.index < slots.size()) {
        deeds.push_back({slots[event.index], "= " + PrintValueBytes(event.bytes)});
      }
    }
  }
  return deeds;
}

// What each thing did in a tick, in one text.
std::map<ThingNumber, std::string> ByThing(const std::vector<Deed>& deeds) {
  std::map<ThingNumber, std::string> by_thing;
  for (const Deed& deed : deeds) {
    std::string& text = by_thing[deed.thing];
    text += (text.empty() ? "" : " ") + deed.what;
  }
  return by_thing;
}

std::vector<std::size_t> TicksOf(const Recording& run) {
  std::vector<std::size_t> ticks;
  for (std::size_t i = 0; i < run.ticks().size(); ++i) {
    if (run.ticks()[i].result != Status::kIdle) ticks.push_back(i);
  }
  return ticks;
}

class Comparer {
 public:
  Comparer(const Recording& first, const Recording& second)
      : first_(first),
        second_(second),
        things_(first.trees().front(), second.trees().front()),
        differences_(things_.names.size()) {}

  RunComparison Compare() {
    const std::vector<std::size_t> first = TicksOf(first_);
    const std::vector<std::size_t> second = TicksOf(second_);
    comparison_.first_ticks = first.size();
    comparison_.second_ticks = second.size();
    comparison_.ticks = std::min(first.size(), second.size());
    for (std::size_t i = 0; i < comparison_.ticks; ++i) CompareTick(first[i], second[i]);
    Finish();
    return std::move(comparison_);
  }

 private:
  void CompareTick(std::size_t first, std::size_t second) {
    const std::vector<Deed> a =
        DeedsIn(first_.EventsOf(first).words, things_.first_nodes, things_.first_slots);
    const std::vector<Deed> b =
        DeedsIn(second_.EventsOf(second).words, things_.second_nodes, things_.second_slots);
    if (!comparison_.parting) FindParting(a, b, first, second);
    const std::map<ThingNumber, std::string> of_first = ByThing(a);
    const std::map<ThingNumber, std::string> of_second = ByThing(b);
    bool is_different = false;
    for (const auto& [thing, text] : of_first) {
      const auto other = of_second.find(thing);
      is_different |= Note(thing, first, text, other == of_second.end() ? "" : other->second);
    }
    for (const auto& [thing, text] : of_second) {
      if (of_first.count(thing) == 0) is_different |= Note(thing, first, "", text);
    }
    comparison_.different_ticks += is_different;
  }

  // Deeds of things that only one tree has do not count.
  void FindParting(const std::vector<Deed>& a, const std::vector<Deed>& b, std::size_t first,
                   std::size_t second) {
    std::size_t i = 0;
    std::size_t k = 0;
    while (true) {
      while (i < a.size() && !things_.are_of_both(a[i].thing)) ++i;
      while (k < b.size() && !things_.are_of_both(b[k].thing)) ++k;
      if (i == a.size() && k == b.size()) return;
      const bool is_same =
          i < a.size() && k < b.size() && a[i].thing == b[k].thing && a[i].what == b[k].what;
      if (!is_same) break;
      ++i;
      ++k;
    }
    PartingPoint parting;
    const Recording::Tick& one = first_.ticks()[first];
    const Recording::Tick& other = second_.ticks()[second];
    parting.tick = one.number;
    parting.second_tick = other.number;
    parting.time = one.start - first_.start();
    parting.second_time = other.start - second_.start();
    parting.what = things_.names[i < a.size() ? a[i].thing : b[k].thing];
    parting.first = i < a.size() ? a[i].what : "nothing more";
    parting.second = k < b.size() ? b[k].what : "nothing more";
    if (i < a.size() && k < b.size() && a[i].thing != b[k].thing) {
      parting.second_what = things_.names[b[k].thing];
    }
    comparison_.parting = std::move(parting);
  }

  // True if that is a difference.
  bool Note(ThingNumber thing, std::size_t tick, const std::string& first,
            const std::string& second) {
    if (first == second || !things_.are_of_both(thing)) return false;
    RunDifference& difference = differences_[thing];
    if (difference.ticks++ > 0) return true;
    difference.what = things_.names[thing];
    difference.first_tick = first_.ticks()[tick].number;
    difference.first = first.empty() ? "not ticked" : first;
    difference.second = second.empty() ? "not ticked" : second;
    if (!things_.is_node[thing]) {
      if (first.empty()) difference.first = "not written";
      if (second.empty()) difference.second = "not written";
    }
    return true;
  }

  void Finish() {
    for (const bool of_nodes : {true, false}) {
      for (ThingNumber i = 0; i < differences_.size(); ++i) {
        if (things_.is_node[i] != of_nodes) continue;
        if (differences_[i].ticks > 0) comparison_.differences.push_back(differences_[i]);
        if (!of_nodes) continue;
        if (!things_.is_of_second[i]) comparison_.only_first.push_back(things_.names[i]);
        if (!things_.is_of_first[i]) comparison_.only_second.push_back(things_.names[i]);
      }
    }
  }

  const Recording& first_;
  const Recording& second_;
  const Things things_;
  std::vector<RunDifference> differences_;
  RunComparison comparison_;
};

std::string SecondOf(const PartingPoint& parting) {
  return (parting.second_what.empty() ? "" : parting.second_what + " ") + parting.second;
}

std::string Seconds(Duration time) {
  std::string text = JsonSeconds(time);
  return text.substr(0, text.size() - 3);
}

}  // namespace

RunComparison CompareRuns(const Recording& first, const Recording& second) {
  return Comparer(first, second).Compare();
}

std::string PrintComparison(const RunComparison& comparison) {
  std::string text;
  if (comparison.is_the_same()) {
    return std::to_string(comparison.ticks) + " ticks: the same\n";
  }
  for (const std::string& path : comparison.only_first) text += "only in the first: " + path + "\n";
  for (const std::string& path : comparison.only_second) {
    text += "only in the second: " + path + "\n";
  }
  if (const auto& parting = comparison.parting) {
    text += "the runs part in tick " + std::to_string(parting->tick) + " (" +
            Seconds(parting->time) + " s) and " + std::to_string(parting->second_tick) + " (" +
            Seconds(parting->second_time) + " s):\n  " + parting->what +
            "\n    first:  " + parting->first + "\n    second: " + SecondOf(*parting) + "\n";
  }
  text += std::to_string(comparison.different_ticks) + " of " + std::to_string(comparison.ticks) +
          " ticks differ; the first run has " + std::to_string(comparison.first_ticks) +
          " ticks, the second " + std::to_string(comparison.second_ticks) + "\n";
  for (const RunDifference& difference : comparison.differences) {
    text += "  " + difference.what + ": " + std::to_string(difference.ticks) +
            " ticks, first in tick " + std::to_string(difference.first_tick) + ": " +
            difference.first + " | " + difference.second + "\n";
  }
  return text;
}

std::string ComparisonToJson(const RunComparison& comparison) {
  const auto difference = [](const RunDifference& d) {
    return JsonObject()
        .AddText("what", d.what)
        .Add("ticks", d.ticks)
        .Add("first_tick", d.first_tick)
        .AddText("first", d.first)
        .AddText("second", d.second)
        .Finish();
  };
  JsonObject object;
  object.AddBool("same", comparison.is_the_same()).Add("ticks", comparison.ticks);
  object.Add("first_ticks", comparison.first_ticks).Add("second_ticks", comparison.second_ticks);
  object.Add("different_ticks", comparison.different_ticks);
  if (const auto& parting = comparison.parting) {
    object.Add("parting", JsonObject()
                              .Add("tick", parting->tick)
                              .Add("second_tick", parting->second_tick)
                              .Add("time", JsonSeconds(parting->time))
                              .Add("second_time", JsonSeconds(parting->second_time))
                              .AddText("what", parting->what)
                              .AddText("first", parting->first)
                              .AddText("second", SecondOf(*parting))
                              .Finish());
  }
  object.Add("differences", JsonArray(comparison.differences, difference));
  object.Add("only_first", JsonArray(comparison.only_first, JsonString));
  object.Add("only_second", JsonArray(comparison.only_second, JsonString));
  return object.Finish();
}

}  // namespace coppice
