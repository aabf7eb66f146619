#include <cstdlib>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/standard_types.h"
#include "bt_core/data/value.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {

int FuzzLiteral(std::string_view bytes) {
  int accepted = 0;
  for (const Type* type :
       {&TypeOf<bool>(), &TypeOf<int>(), &TypeOf<unsigned>(), &TypeOf<long>(),
        &TypeOf<unsigned long>(), &TypeOf<float>(), &TypeOf<double>(), &TypeOf<std::string>(),
        &TypeOf<Status>(), &TypeOf<Duration>(), &TypeOf<std::vector<double>>()}) {
    Value value;
    if (!value.Parse(*type, bytes)) {
      if (value.has_value()) std::abort();
      continue;
    }
    ++accepted;
    const std::string printed = value.Print();
    Value json;
    if (!json.FromJson(*type, value.ToJson()) || json.ToJson() != value.ToJson()) std::abort();
    Value again;
    if (!again.Parse(*type, printed) || again.Print() != printed) std::abort();
  }
  return accepted;
}

}  // namespace coppice::fuzz
