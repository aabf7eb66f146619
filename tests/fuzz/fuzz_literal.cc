#include <cstdlib>

#include "bt_core/data/value.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {

int FuzzLiteral(std::string_view bytes) {
  int accepted = 0;
  for (const Type* type : {&TypeOf<bool>(), &TypeOf<int>(), &TypeOf<unsigned>(), &TypeOf<long>(),
                           &TypeOf<unsigned long>(), &TypeOf<double>(), &TypeOf<std::string>()}) {
    Value value;
    if (!value.Parse(*type, bytes)) {
      if (value.has_value()) std::abort();
      continue;
    }
    ++accepted;
    const std::string printed = value.Print();
    Value again;
    if (!again.Parse(*type, printed) || again.Print() != printed) std::abort();
  }
  return accepted;
}

}  // namespace coppice::fuzz
