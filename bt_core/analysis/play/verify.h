// Runs a recorded run again and holds every event against the record: the engine must do the same,
// bit for bit, if it gets the same results of leaves, the same messages from outside, the same
// injected results and the same times.
//
//   Diagnostics diagnostics;
//   const Verification check = Verify(recording, {}, diagnostics);
//   if (!check.divergence) std::cout << check.ticks << " ticks, " << check.events << " events";
//
// What is played: built-in nodes are run; nodes of the user give the recorded results, writes and
// messages, and tick or halt the children that they ticked or halted then. A record that begins or
// goes on while the tree runs says nothing of what its nodes remember, so there the verification
// waits until no node runs. Values of types that are only known to the application (without its
// plugin) are taken as they are.
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_VERIFY_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_VERIFY_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/play/prompter.h"
#include "bt_core/analysis/recording.h"

namespace coppice {

struct Verification {
  std::uint64_t ticks = 0;           ///< played again, and halts
  std::uint64_t events = 0;          ///< that were the same
  std::uint64_t skipped_ticks = 0;   ///< that could not be played
  std::vector<std::string> remarks;  ///< why not, and where it went on
  std::optional<Divergence> divergence;

  bool is_the_same() const { return !divergence && ticks > 0; }
};

/// Makes the registry that a recorded tree is compiled with; empty: the built-in nodes.
using RegistryMaker = std::function<std::shared_ptr<Registry>()>;

Verification Verify(const Recording& run, const RegistryMaker& make_registry,
                    Diagnostics& diagnostics);

/// "1200 ticks, 34567 events: the same", or where the runs part; then the remarks.
std::string PrintVerification(const Verification& verification, Time start);
std::string VerificationToJson(const Verification& verification, Time start);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_VERIFY_H_
