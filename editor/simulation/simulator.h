// The one simulation that an editor runs: begins and ends it, lets it run at a speed, and reloads
// it when its tree is edited.
//
//   Simulator simulator;
//   workspace.AddRun(simulator.Start(project, "patrol.xml", "", diagnostics));
//   simulator.Play();
//   simulator.Update(project, now);      // once per frame
#ifndef COPPICE_EDITOR_SIMULATION_SIMULATOR_H_
#define COPPICE_EDITOR_SIMULATION_SIMULATOR_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "editor/files/open_project.h"
#include "editor/live/run_source.h"
#include "editor/simulation/simulation.h"

namespace coppice::editor {

class Simulator {
 public:
  static constexpr char kName[] = "simulation";  ///< of the run

  /// Begins a simulation of a tree (empty ID: the main tree) of a file and returns its run, which
  /// ends the simulation when it goes. The scenarios beside it (random_suite.h) name the models of
  /// its node types. Null, with the reasons, if the tree has errors; what is wrong with the
  /// scenarios is only said.
  std::unique_ptr<RunSource> Start(OpenProject& files, const std::string& path,
                                   const std::string& tree_id, Diagnostics& diagnostics);

  /// Null if there is none.
  Simulation* get() const;
  /// What the scenarios beside the tree say of running it by chance, read anew. Nothing, with the
  /// reasons, if that has errors. There must be a simulation.
  std::optional<RandomPlay> ReadRandomPlay(Diagnostics& diagnostics) const;
  const std::string& path() const { return path_; }
  /// Empty for the main tree of the file.
  const std::string& tree_id() const { return tree_id_; }

  bool is_playing() const { return get() && is_playing_; }
  void Play();
  void Pause() { is_playing_ = false; }
  /// Times faster than a clock, from 1/10 to 1000.
  double speed() const { return speed_; }
  void SetSpeed(double speed);
  /// Time from tick to tick, from 1 ms to 10 s.
  Duration period() const { return period_; }
  void SetPeriod(Duration period);

  /// Ticks as often as the time that has passed tells; stops when the tree is done. Reloads what
  /// was edited.
  void Update(OpenProject& files, double now);
  /// Seconds until there is something to do; infinity: nothing.
  double NextUpdateIn(double now) const;

  /// What the tree returned when it was done last and has not been ticked since; nothing while it
  /// is begun anew (Simulation::is_begun_anew).
  std::optional<Status> result() const { return get() ? result_ : std::nullopt; }
  void SetResult(Status status);
  /// Why the text as it is now cannot be simulated; meanwhile the tree before it goes on.
  const std::string& problem() const { return problem_; }

 private:
  class Source;
  struct Stage;  // the simulation, and what it has to tell

  void ReloadIfEdited(OpenProject& files, double now);
  bool IsSameText(const Program& program) const;

  std::shared_ptr<Stage> stage_;
  std::string path_;
  std::string tree_id_;
  std::optional<Project> models_;
  bool is_playing_ = false;
  double speed_ = 1;
  Duration period_ = std::chrono::milliseconds(100);
  double now_ = 0;
  double due_ = 0;  // seconds of the simulation that are still to be played
  std::optional<Status> result_;
  std::string problem_;
  std::uint64_t version_ = 0;         // of the files that were looked at
  std::optional<double> compile_at_;  // edits that come together are compiled once
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SIMULATOR_H_
