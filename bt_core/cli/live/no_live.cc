// The verbs that need the live socket, without it (-DCOPPICE_LIVE=OFF).
#include <iostream>

#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

int Refuse(const char* verb) {
  std::cerr << "coppice " << verb << ": this coppice was built without the live view\n";
  return 2;
}

}  // namespace

int RunLive(const Arguments&) { return Refuse("live"); }
int RunRecord(const Arguments&) { return Refuse("record"); }

}  // namespace coppice
