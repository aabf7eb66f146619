// WakeUp where there is one thread only: nobody could notify while it waits, so it does not.
#include "bt_core/base/wake_up.h"

namespace coppice {

bool WakeUp::Consume() { return state_.exchange(kQuiet, std::memory_order_acq_rel) == kNotified; }

void WakeUp::Rouse() {}

bool WakeUp::WaitFor(std::chrono::nanoseconds) { return Consume(); }

}  // namespace coppice
