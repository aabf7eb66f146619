// Runs deployments of many seeds and keeps each as a file. A seed that has its file is done, so a
// run that was broken off goes on where it was, and many computers may share the seeds.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_RUN_SEEDS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_RUN_SEEDS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/deployment/figures/journal.h"
#include "robot_app/deployment/robot/controller.h"
#include "robot_app/deployment/robot/shipped.h"
#include "robot_app/deployment/scenario/scenario.h"

namespace coppice::robot::deployment {

/// "1-20", "3", "1-5,9": at most 10 000 seeds.
Expected<std::vector<std::uint64_t>> ParseSeeds(const std::string& text);

struct SeedOptions {
  std::string folder;  ///< of the controller; made if needed
  bool is_recorded = false;
  std::vector<std::string> without;  ///< of the scenario, for the journal
  double times = 1;
  int jobs = 1;
  bool tells_progress = false;  ///< on the standard error output
};

/// "FOLDER/seed-0007".
std::string NameOfSeed(const std::string& folder, std::uint64_t seed);

/// One seed, without files but for its records (`record`, see Robot).
Journal RunSeed(const Scenario& scenario, const Shipped& shipped, const Controller& controller,
                std::uint64_t seed, const std::string& record);

/// All that are not done yet. A problem of the first one that could not be kept.
Outcome RunSeeds(const Scenario& scenario, const Shipped& shipped, const Controller& controller,
                 const std::vector<std::uint64_t>& seeds, const SeedOptions& options);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_RUN_SEEDS_H_
