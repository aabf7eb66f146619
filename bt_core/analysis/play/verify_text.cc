#include <cstdio>

#include "bt_core/analysis/json_writer.h"
#include "bt_core/analysis/play/verify.h"

namespace coppice {
namespace {

std::string Seconds(Duration time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

}  // namespace

std::string PrintVerification(const Verification& verification, Time start) {
  std::string text = std::to_string(verification.ticks) + " ticks, " +
                     std::to_string(verification.events) + " events: ";
  if (const auto& parted = verification.divergence) {
    text += "the same until tick " + std::to_string(parted->tick) + " at " +
            Seconds(parted->time - start) + " s\n";
    if (!parted->node.empty()) text += "  node:     " + parted->node + "\n";
    text += "  recorded: " + parted->expected + "\n  now:      " + parted->actual + "\n";
  } else {
    text += verification.ticks > 0 ? "the same\n" : "nothing could be verified\n";
  }
  if (verification.skipped_ticks > 0) {
    text += std::to_string(verification.skipped_ticks) + " ticks were not verified\n";
  }
  for (const std::string& remark : verification.remarks) text += remark + "\n";
  return text;
}

std::string VerificationToJson(const Verification& verification, Time start) {
  JsonObject object;
  object.AddBool("same", verification.is_the_same()).Add("ticks", verification.ticks);
  object.Add("events", verification.events).Add("skipped_ticks", verification.skipped_ticks);
  object.Add("remarks", JsonArray(verification.remarks, JsonText));
  if (const auto& parted = verification.divergence) {
    object.Add("divergence", JsonObject()
                                 .Add("tick", parted->tick)
                                 .Add("time", JsonSeconds(parted->time - start))
                                 .AddText("node", parted->node)
                                 .AddText("recorded", parted->expected)
                                 .AddText("now", parted->actual)
                                 .Finish());
  }
  return object.Finish();
}

}  // namespace coppice
