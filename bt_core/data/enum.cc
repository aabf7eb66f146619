#include "bt_core/data/enum.h"

#include "bt_core/data/value.h"

namespace coppice {

const Enumerator* FindEnumerator(const EnumeratorList& list, std::string_view text) {
  for (const Enumerator& enumerator : list) {
    if (enumerator.name == text) return &enumerator;
  }
  std::int64_t value = 0;
  if (!ValueTraits<std::int64_t>::Parse(text, value)) return nullptr;
  return FindEnumerator(list, value);
}

const Enumerator* FindEnumerator(const EnumeratorList& list, std::int64_t value) {
  for (const Enumerator& enumerator : list) {
    if (enumerator.value == value) return &enumerator;
  }
  return nullptr;
}

std::string Choices(const EnumeratorList& list) {
  std::string text;
  for (const Enumerator& enumerator : list) {
    const bool last = &enumerator + 1 == list.end();
    if (!text.empty()) text += last ? " or " : ", ";
    text += enumerator.name;
  }
  return text;
}

}  // namespace coppice
