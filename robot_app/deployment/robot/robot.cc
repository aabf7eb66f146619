#include "robot_app/deployment/robot/robot.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "robot_app/deployment/robot/senses.h"

namespace coppice::robot::deployment {
namespace {

constexpr char kTrees[] = "/coppice_robot";
// How long the monitors look often after something has happened, and how often they do afterwards
// while something is wrong, or nothing is [s].
constexpr double kAttentive = 30, kInTrouble = 5, kAllIsWell = 60;
// The monitor tree acts on reports that are no older than this [s].
constexpr double kFresh = 1;
// Ticks of a moment; a tree that wants still more gets them a little later.
constexpr int kMostTicks = 20;
constexpr Duration kLittle = std::chrono::milliseconds(1);
constexpr double kFaceLasts = 4;                  // s
constexpr double kStanding = 0, kDriving = 0.01;  // effort, as simulation::Battery
constexpr double kDetour = 1.5;                   // as of leaves::WayHome
// What keeps the robot from its work when it is an error.
constexpr char kTroubles[] = "node;topic;navigation;localization;docking;supervisor";

Pose2D FromFloor(const simulation::Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

SitePhrases PhrasesOf(const Shipped& shipped, const World& world) {
  Diagnostics diagnostics;
  SitePhrases phrases(shipped.Path("robot_app/config/phrases.yaml"), diagnostics, [&world] {
    return static_cast<int>(SecondsOf({DayAt(world.now()).from, world.now()}) / 60);
  });
  if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.ToString());
  return phrases;
}

std::vector<assistance::HumanSupervisor> AskedBy(const Controller& controller,
                                                 const Shipped& shipped) {
  std::vector<assistance::HumanSupervisor> people = shipped.people.supervisors;
  if (!controller.asks_all) people.resize(1);
  return people;
}

RunId RunIdOf(std::uint64_t seed) {
  RunId id{};
  id[0] = 'd';
  for (std::size_t i = 0; i < 8; ++i) id[15 - i] = static_cast<std::uint8_t>(seed >> (8 * i));
  return id;
}

}  // namespace

Robot::Robot(World& world, const Shipped& shipped, const Controller& controller, std::string record)
    : world_(world),
      shipped_(shipped),
      controller_(controller),
      record_(std::move(record)),
      ways_(shipped.floor),
      moving_(world),
      programs_(world, Changed(shipped.robot, controller)),
      drive_(world, ways_, programs_, controller.gives_up),
      station_(world, programs_, FromFloor(shipped.floor.docked), FromFloor(shipped.floor.staging),
               controller.contact_is_success),
      position_(world),
      helpers_(world, AskedBy(controller, shipped),
               [this](const std::string& subject) { return shipped_.people.RulesOf(subject); }),
      watchers_(Changed(shipped.monitors, controller),
                {world, ways_, programs_, drive_, station_, position_}, controller.lost_after),
      faults_(world, moving_, ways_, drive_, position_, programs_),
      keeper_(world, moving_, programs_, helpers_),
      places_(shipped.Path("robot_app/config/sites/institute/places.yaml"),
              static_cast<unsigned>(world.seed), world.clock),
      phrases_(PhrasesOf(shipped, world)),
      surface_(world, programs_),
      manager_(world, programs_, shipped.robot) {
  world_.pose = FromFloor(shipped.floor.docked);
  Wire();
}

void Robot::Wire() {
  drive_.on_moved = [this](double distance) { faults_.OnMoved(distance); };
  drive_.on_rotated = [this] { position_.OnRotated(); };
  position_.on_change = [this] {
    drive_.Review();
    Notice();
  };
  station_.on_contact = [this] {
    if (world_.docked) position_.Find();
    if (world_.has_current) world_.battery_key_is_stuck = false;
    drive_.Review();
    Notice();
  };
  programs_.on_ready = [this](const std::string& node, bool cleared) { OnReady(node, cleared); };
  programs_.on_end = [this](const std::string& node) {
    if (node == kTrees) StopTrees();
    drive_.Review();
    Notice();
  };
  programs_.on_loop_noticed = [this] { keeper_.OnLoopNoticed(); };
  faults_.on_fault = [this] {
    drive_.Review();
    Notice();
  };
  faults_.on_face = [this](bool has_mask) { ShowFace(has_mask); };
  surface_.on_recovery = [this] { Notice(); };
  helpers_.on_help = [this](const std::string& subject) { Help(subject); };
  keeper_.on_intervention = [this] { PutRight(); };
}

// ---- the trees

std::unique_ptr<Tree> Robot::MakeTree(const std::string& name, const std::string& file) {
  TreeOptions options;
  options.name = name;
  options.file = shipped_.Path(file);
  options.pretended = controller_.pretended;
  if (!record_.empty()) {
    const std::string number = starts_ > 1 ? "." + std::to_string(starts_) : "";
    options.record = record_ + "." + name + number + ".coppice";
    options.run = RunIdOf(world_.seed);
    const std::size_t slash = options.record.rfind('/');
    world_.journal.records.push_back(options.record.substr(slash + 1));
  }
  const leaves::Capabilities capabilities{drive_,   places_,  places_,  station_,
                                          surface_, surface_, surface_, phrases_,
                                          manager_, helpers_, link_,    surface_};
  return std::make_unique<Tree>(options, capabilities, world_.clock);
}

Robot::Keys Robot::KeysOf(Executor& executor) {
  Keys keys;
  keys.battery_level = executor.Writer<double>("battery_level");
  keys.distance_to_station = executor.Writer<double>("distance_to_station");
  keys.duty_left = executor.Writer<double>("duty_left");
  keys.charging = executor.Writer<bool>("charging");
  keys.docked = executor.Writer<bool>("docked");
  keys.manual = executor.Writer<bool>("manual");
  keys.monitoring = executor.Writer<leaves::Health>("monitoring");
  keys.configuration = executor.Writer<std::string>("configuration");
  keys.processes = executor.Writer<std::string>("processes");
  keys.battery = executor.Writer<leaves::BatteryReading>("battery");
  keys.pose = executor.Writer<leaves::Pose2D>("pose");
  keys.people = executor.Writer<leaves::PeopleView>("people");
  return keys;
}

void Robot::StartTrees() {
  ++starts_;
  application_ = MakeTree("application", controller_.application);
  monitor_ = MakeTree("monitor", controller_.monitor);
  Executor& application = application_->executor();
  application.Writer<int>("rounds").Send(-1);
  application.Writer<int>("stops").Send(4);
  keys_ = {KeysOf(application), KeysOf(monitor_->executor())};
  for (const Keys& keys : keys_) keys.processes.Send("[]");
  link_.Connect(&*application_, &*monitor_);
  next_look_ = world_.now();
}

void Robot::StopTrees() {
  drive_.CancelNavigation();
  drive_.CancelMotion();
  station_.CancelDocking();
  link_ = Link();
  keys_.clear();
  monitor_.reset();
  application_.reset();
  surface_.ForgetRecoveries();
}

void Robot::ShowFace(bool has_mask) {
  if (keys_.empty() || has_mask || !programs_.Works("/people_tracker")) return;
  leaves::PeopleView view;
  view.stamp = world_.now();
  leaves::SeenPerson person;
  person.id = static_cast<std::uint32_t>(world_.journal.without_mask);
  person.x = 2;
  person.known_for = 1;
  person.mask = leaves::Mask::kWithout;
  view.people = {person};
  keys_[0].people.Send(view);
  world_.After(kFaceLasts, [this] {
    leaves::PeopleView nobody;
    nobody.stamp = world_.now();
    if (!keys_.empty()) keys_[0].people.Send(nobody);
  });
}

// ---- one moment

void Robot::Run(const std::function<void(Time)>& progress) {
  const Time end = world_.scenario.calendar.span().to;
  programs_.Step();
  faults_.Begin();
  Time told{};
  while (world_.now() < end) {
    world_.events.RunDue(world_.now());
    if (!world_.is_off) StepParts();
    Judge();
    if (progress && world_.now() - told > std::chrono::hours(1)) progress(told = world_.now());
    Advance();
  }
  keeper_.Close();
  StopTrees();
}

void Robot::StepParts() {
  const bool is_look_due = world_.now() >= next_look_;
  if (is_look_due || programs_.IsBusy()) {
    for (const std::string& call : programs_.Step()) {
      helpers_.Ask("programs", call, {});
      Notice();
    }
  }
  helpers_.Step(programs_.Works("/assistance"));
  if (manager_.TakeCut()) return SwitchOff();
  if (is_look_due) Look();
  TickTrees();
}

double Robot::LookPeriod() const {
  const double often = std::chrono::duration<double>(watchers_.period()).count();
  if (SecondsOf({noticed_, world_.now()}) < kAttentive || station_.is_busy()) return often;
  const bool is_wrong = watchers_.sees_trouble() || helpers_.is_asking() || programs_.IsBusy() ||
                        world_.loss != Loss::kNone || world_.hindrance != Hindrance::kNone ||
                        surface_.is_recovering();
  return is_wrong ? std::max(often, kInTrouble) : kAllIsWell;
}

void Robot::Look() {
  const std::optional<leaves::Health> health = watchers_.Look();
  if (watchers_.has_changed()) Notice();
  if (health) has_errors_ = health->HasError(kTroubles);
  if (programs_.Works(kTrees)) {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (health) keys_[i].monitoring.Send(*health);
      Feed(keys_[i], i == 0);
    }
  }
  next_look_ = world_.now() + Seconds(LookPeriod());
}

void Robot::Feed(const Keys& keys, bool is_application) const {
  if (programs_.Works("/simulator")) {
    const leaves::BatteryReading reading = ReadBattery(world_);
    if (!is_application || !world_.battery_key_is_stuck) keys.battery_level.Send(reading.level);
    keys.charging.Send(*leaves::CurrentFlows(reading));
    keys.docked.Send(*leaves::StandsOnStation(reading));
    keys.battery.Send(reading);
  }
  if (!is_application && programs_.Works("/people_tracker")) keys.people.Send(SeePeople(world_));
  keys.configuration.Send(programs_.supervisor().configuration());
  keys.manual.Send(false);
  const double left = world_.scenario.calendar.DutyLeft(world_.now());
  keys.duty_left.Send(controller_.plans_charging || left <= 0 ? left : 86400.0);
  FeedPose(keys);
}

// Who follows a way has to know where it ended: no tick of the application is without it.
void Robot::FeedPose(const Keys& keys) const {
  if (!programs_.Works("/localization")) return;
  keys.pose.Send(world_.pose);
  const Pose2D station = FromFloor(shipped_.floor.staging);
  keys.distance_to_station.Send(
      ways_.LengthHome(world_.pose).value_or(kDetour * Distance(world_.pose, station)));
}

void Robot::TickTrees() {
  const auto is_due = [this](const std::unique_ptr<Tree>& tree) {
    return tree && tree->Due() <= world_.now();
  };
  const bool is_wanted = is_due(application_) || is_due(monitor_);
  if (!is_wanted || !programs_.Works(kTrees)) return;
  // With the newest report: between two looks nothing has changed that they would have seen.
  if (is_due(monitor_) && SecondsOf({next_look_ - Seconds(LookPeriod()), world_.now()}) > kFresh) {
    Look();
  }
  for (int i = 0; i < kMostTicks && (is_due(application_) || is_due(monitor_)); ++i) {
    if (is_due(monitor_)) monitor_->Tick();
    if (!is_due(application_)) continue;
    FeedPose(keys_.front());
    application_->Tick();
  }
}

bool Robot::IsInTrouble() const {
  return has_errors_ || surface_.is_recovering() || world_.loss != Loss::kNone;
}

void Robot::Judge() { keeper_.Note(IsInTrouble(), link_.is_going_home()); }

void Robot::Advance() {
  const Time now = world_.now();
  Time next = std::min(world_.events.next(), world_.scenario.calendar.span().to);
  next = std::min(next, world_.scenario.calendar.NextChange(now));
  if (world_.is_off) {
    next = std::min(next, now + Seconds(kAllIsWell));
  } else {
    next = std::min(next, next_look_);
    const bool tick = programs_.Works(kTrees);
    if (tick && application_) next = std::min(next, application_->Due());
    if (tick && monitor_) next = std::min(next, monitor_->Due());
  }
  next = std::max(next, now + kLittle);
  LiveThrough(SecondsOf({now, next}));
  if (world_.scenario.calendar.NextChange(now) == next) next_look_ = next;
  world_.clock.Advance(next - now);
}

// The wheels turn for a part of the time; the rest of it is waiting for people and turning.
void Robot::LiveThrough(double seconds) {
  if (world_.is_off || seconds <= 0) return;
  simulation::Battery& battery = world_.battery;
  const double before = battery.charge();
  const double share =
      world_.rolls ? world_.scenario.effective_speed / world_.scenario.command_speed : 0;
  const bool feeds = world_.docked && world_.has_current;
  if (share > 0) battery.Step(seconds * share, kDriving, feeds);
  battery.Step(seconds * (1 - share), kStanding, feeds);
  world_.current = battery.full() ? 0 : (battery.charge() - before) / seconds * 3600;
  if (battery.empty()) SwitchOff();
}

// ---- what happens to it

void Robot::OnReady(const std::string& node, bool is_cleared) {
  if (node == kTrees) StartTrees();
  if (node == "/localization") position_.OnRestarted(is_cleared);
  if (node == "/health_aggregator") watchers_.ForgetReports();
  drive_.Review();
  Notice();
}

void Robot::Help(const std::string& subject) {
  if (subject == "navigation" && world_.hindrance != Hindrance::kNone) {
    faults_.ClearHindrance();
  } else if (subject == "localization") {
    position_.Find();
  } else if (subject == "docking" || subject == "charging" || subject == "battery" ||
             subject == "undocking") {
    station_.Repair(subject != "undocking");
  } else {
    programs_.RestartAll();
  }
  Notice();
}

void Robot::SwitchOff() {
  StopTrees();
  world_.is_off = true;
  world_.rolls = false;
}

void Robot::PutRight() {
  faults_.ClearHindrance();
  position_.Find();
  if (world_.is_off || world_.docked || world_.station_is_broken ||
      world_.battery.state_of_charge() < world_.scenario.low_battery_seen) {
    station_.Repair(true);
  }
  world_.battery_key_is_stuck = false;
  if (std::exchange(world_.is_off, false)) {
    programs_.PowerUp();
    manager_.Reset();
  } else if (programs_.loops() || programs_.IsBusy()) {
    programs_.RestartAll();
  }
  next_look_ = world_.now();
  Notice();
}

}  // namespace coppice::robot::deployment
