// Priority inversion never: whatever faults come and go, whenever restarts are refused and however
// people answer, the most urgent fault about which something can be done is the one that is acted
// upon, in the same tick. Held against a plain account of what can be done.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

// The branches that act, most urgent first, and the monitors that call for them.
struct Class {
  const char* branch;
  const char* monitor;
  const char* request;  // for help
};
constexpr std::array<Class, 3> kClasses = {{{"node_or_topic", "node", "nodes"},
                                            {"navigation", "navigation", "navigation"},
                                            {"localization", "localization", "localization"}}};

class World {
 public:
  explicit World(std::uint32_t seed) : random_(seed) {
    scenario_.Set("charging", false);
    scenario_.Set("docked", false);
    scenario_.Set("going_home", false);
  }

  // Half a second: faults come and go, the robot's actions end well or not, people answer.
  void Step() {
    for (const char* fault : {"node /a", "node /b", "navigation path", "localization /l",
                              "cpu host", "emergency_stop button"}) {
      Flip(fault, faults_.count(fault) ? 0.02 : 0.01);
    }
    if (Happens(0.3)) scenario_.robot.done.Send({Happens(0.6), "random"});
    if (!scenario_.robot.open_requests.empty() && Happens(0.02)) {
      const std::string subject = scenario_.robot.open_requests.begin()->first;
      const bool is_fixed = Happens(0.5);
      scenario_.robot.AnswerRequest(subject, is_fixed);
      if (is_fixed) confirmed_.insert(subject);
      if (!is_fixed) rests_until_[subject] = scenario_.now() + std::chrono::seconds(900);
    }
    scenario_.Advance(0.5);
    scenario_.Set("battery",
                  leaves::BatteryReading{scenario_.now(), 25, 12, 0.95, leaves::kNotMeasured, {}});
    Report();
    scenario_.Tick();
  }

  bool HasFault(const std::string& monitor) const {
    for (const std::string& fault : faults_) {
      if (fault.rfind(monitor + " ", 0) == 0) return true;
    }
    return false;
  }

  // What the tree does now, most urgent first; at most one branch may act.
  std::vector<std::string> Acting() const {
    std::vector<std::string> acting;
    for (const Class& one : kClasses) {
      if (scenario_.Runs(one.branch)) acting.push_back(one.branch);
    }
    return acting;
  }

  // Nobody could help: it is not asked again for ten minutes from the time the tree took that in,
  // which may be minutes later, when the branch is looked at again.
  bool Rests(const std::string& request) const {
    const auto rests = rests_until_.find(request);
    return rests != rests_until_.end() && scenario_.now() < rests->second;
  }

  // A person has said that it is fixed: that is taken in in one tick, and if the fault is still
  // there the ladder begins anew in the next; if its budgets are used up, nobody is asked for ten
  // seconds. True once for each confirmation.
  bool TakeConfirmation(const std::string& request) {
    if (confirmed_.erase(request) == 0) return false;
    rests_until_[request] = scenario_.now() + std::chrono::seconds(11);
    return true;
  }

  std::string Describe() const {
    std::string text;
    for (const std::string& fault : faults_) text += fault + "; ";
    return text;
  }

  TreeScenario scenario_{"monitor/monitor.xml"};

 private:
  bool Happens(double probability) {
    return std::uniform_real_distribution<>(0, 1)(random_) < probability;
  }
  void Flip(const std::string& fault, double probability) {
    if (!Happens(probability)) return;
    if (faults_.erase(fault) == 0) faults_.insert(fault);
  }
  void Report() {
    std::vector<std::pair<std::string, std::string>> errors;
    for (const std::string& fault : faults_) {
      const std::size_t blank = fault.find(' ');
      errors.emplace_back(fault.substr(0, blank), fault.substr(blank + 1));
    }
    scenario_.Report(errors);
  }

  std::mt19937 random_;
  std::set<std::string> faults_;
  std::map<std::string, Time> rests_until_;
  std::set<std::string> confirmed_;
};

// A branch with a fault may stand back only if it waits for a person (its request is open, or it
// was answered and rests), or if the robot must not move.
class Oracle {
 public:
  void Check(World& world) {
    const std::vector<std::string> acting = world.Acting();
    ASSERT_LE(acting.size(), 1u) << world.Describe();
    const bool must_not_move = world.HasFault("emergency_stop");
    for (const Class& one : kClasses) {
      const bool acts = !acting.empty() && acting[0] == one.branch;
      const bool has_fault = world.HasFault(one.monitor);
      Note(world, one);
      if (acts) return;  // nothing further left could have acted: those were looked at before
      const bool moves = std::string(one.monitor) != "node";
      if (!has_fault || (moves && must_not_move)) continue;
      if (waits_.count(one.branch) || world.Rests(one.request)) continue;
      EXPECT_TRUE(world.TakeConfirmation(one.request))
          << one.branch << " has a fault, does not act and waits for nobody; acting: "
          << (acting.empty() ? "none" : acting[0]) << "; faults: " << world.Describe();
    }
  }

 private:
  // A branch that has asked waits until its fault has gone or it acts again.
  void Note(const World& world, const Class& one) {
    const bool asks = world.scenario_.robot.open_requests.count(one.request) > 0;
    if (asks) waits_.insert(one.branch);
    if (world.scenario_.Runs(one.branch)) waits_.erase(one.branch);
    if (world.scenario_.StatusOf(one.branch) == Status::kSuccess) waits_.insert(one.branch);
    if (!world.HasFault(one.monitor)) waits_.erase(one.branch);
  }
  std::set<std::string> waits_;
};

TEST(Priority, IsNeverInvertedWhateverHappens) {
  long acted = 0;
  long asked = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    World world(seed);
    Oracle oracle;
    for (int step = 0; step < 2000; ++step) {
      world.Step();
      oracle.Check(world);
      if (testing::Test::HasFailure()) FAIL() << "seed " << seed << ", step " << step;
      acted += !world.Acting().empty();
    }
    asked += world.scenario_.CallsBeginning("Ask");
  }
  EXPECT_GT(acted, 10000) << "else nothing was tested";
  EXPECT_GT(asked, 100);
}

// All sets of faults, beginning in the same tick: the most urgent one is acted upon at once.
TEST(Priority, TheMostUrgentOfAnySetOfFaultsIsActedUponInTheFirstTick) {
  for (unsigned set = 1; set < 8; ++set) {
    TreeScenario scenario("monitor/monitor.xml");
    std::vector<std::pair<std::string, std::string>> errors;
    for (unsigned k = 3; k-- > 0;) {  // in the reverse order
      if (set >> k & 1) errors.emplace_back(kClasses[k].monitor, "/x");
    }
    scenario.Report(errors);
    scenario.Tick();
    bool is_first = true;
    for (unsigned k = 0; k < 3; ++k) {
      EXPECT_EQ(scenario.Runs(kClasses[k].branch), (set >> k & 1) && is_first) << set;
      if (set >> k & 1) is_first = false;
    }
  }
}

// Every pair: what is more urgent takes over from what is running in the very tick it is reported.
TEST(Priority, AMoreUrgentFaultPreemptsInTheSameTick) {
  for (unsigned low = 1; low < 3; ++low) {
    for (unsigned high = 0; high < low; ++high) {
      TreeScenario scenario("monitor/monitor.xml");
      scenario.Report({{kClasses[low].monitor, "/x"}});
      scenario.Tick();
      ASSERT_TRUE(scenario.Runs(kClasses[low].branch));
      scenario.Report({{kClasses[low].monitor, "/x"}, {kClasses[high].monitor, "/y"}});
      scenario.Tick();
      EXPECT_TRUE(scenario.Runs(kClasses[high].branch));
      EXPECT_FALSE(scenario.Runs(kClasses[low].branch));
    }
  }
}

// The same reports at the same times lead to the same calls, to the last one.
TEST(Priority, TheSameInputLeadsToTheSameActions) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    World one(seed);
    World other(seed);
    for (int step = 0; step < 2000; ++step) {
      one.Step();
      other.Step();
    }
    EXPECT_EQ(one.scenario_.robot.calls, other.scenario_.robot.calls);
    EXPECT_GT(one.scenario_.robot.calls.size(), 10u);
  }
}

// Whatever runs, the configuration and the reports come first, and the battery and the requests for
// help are not forgotten.
TEST(Priority, ConfigurationReportsWatchdogAndRequestsAreLookedAtInEveryTickInThisOrder) {
  const std::vector<std::string> always = {"check_and_set_configuration", "process_monitors",
                                           "battery_watchdog", "settle_requests"};
  World world(1);
  world.scenario_.Follow(always);
  int busy = 0;
  for (int step = 0; step < 500; ++step) {
    world.Step();
    ASSERT_EQ(world.scenario_.Followed(), always) << "step " << step << ", " << world.Describe();
    busy += !world.Acting().empty();
  }
  EXPECT_GT(busy, 100) << "else nothing stood in the way";
}

}  // namespace
}  // namespace coppice
