#include "behaviortree_cpp/blackboard.h"

#include <algorithm>
#include <chrono>

#include "behaviortree_cpp/json_export.h"

namespace BT {
namespace internal {
namespace {

std::string ShownType(const Cell& cell) {
  const coppice::Type* const type = cell.slot->value.type();
  return !cell.info.isStronglyTyped() && type ? demangle(*type->info) : demangle(cell.info.type());
}

std::type_index DeclaredType(const Cell& cell) { return cell.info.type(); }

[[noreturn]] void ThrowMismatch(StringView key, const Cell& cell, const std::type_index& given) {
  throw LogicError("Blackboard::set(", key,
                   "): once declared, the type of a port shall not change. Previously declared "
                   "type [",
                   demangle(DeclaredType(cell)), "], current type [", demangle(given), "]");
}

template <class T>
bool FitsAs(const std::type_index& type, const Number& number, Any& out) {
  T value{};
  if (type != typeid(T) || !Fits(number, value)) return false;
  out = Any(value);
  return true;
}

// The number as the declared type has it; false if that is no number or cannot hold it.
bool AsDeclared(const std::type_index& type, const Number& number, Any& out) {
  return FitsAs<int>(type, number, out) || FitsAs<unsigned>(type, number, out) ||
         FitsAs<std::int64_t>(type, number, out) || FitsAs<std::uint64_t>(type, number, out) ||
         FitsAs<double>(type, number, out) || FitsAs<float>(type, number, out) ||
         FitsAs<bool>(type, number, out) || FitsAs<std::int8_t>(type, number, out) ||
         FitsAs<std::uint8_t>(type, number, out) || FitsAs<std::int16_t>(type, number, out) ||
         FitsAs<std::uint16_t>(type, number, out);
}

// What ports and earlier writers say of the key.
void ConvertToDeclared(Cell& cell, Written& written, StringView key) {
  if (!cell.info.isStronglyTyped()) {
    if (written.type != typeid(Any)) cell.info = TypeInfo(written.type, written.converter());
    return;
  }
  const std::type_index declared = DeclaredType(cell);
  if (declared == written.type || declared == written.value.type()) return;
  if (written.value.isString()) {
    Any parsed = cell.info.parseString(written.value.cast<std::string>());
    if (parsed.empty()) ThrowMismatch(key, cell, written.type);
    written.value = std::move(parsed);
  } else if (!AsDeclared(declared, NumberOf(written.value.value()), written.value)) {
    ThrowMismatch(key, cell, written.type);
  }
}

// What built-in nodes of the tree read the key as.
void ConvertToDemanded(const Cell& cell, coppice::Value& value, StringView key) {
  if (!cell.demanded || value.type() == cell.demanded || !value.has_value()) return;
  coppice::Value converted;
  if (!converted.Parse(*cell.demanded, value.Print())) {
    throw LogicError("key [", key, "]: ", value.Print(), " is no ", cell.demanded->name,
                     ", which a node of the tree reads");
  }
  value = std::move(converted);
}

}  // namespace

void CountWrite(Cell& cell) {
  if (cell.now) return cell.slot->CountWrite(*cell.now);
  cell.slot->CountWrite(coppice::Time(std::chrono::steady_clock::now().time_since_epoch()));
}

void Write(Cell& cell, Written written, StringView key) {
  const GateLock lock(*cell.gate);
  ConvertToDeclared(cell, written, key);
  coppice::Value& value = written.value.value();
  const coppice::Type* const given = value.type();
  ConvertToDemanded(cell, value, key);
  if (given == value.type() && value.has_value()) {
    const bool is_declared = DeclaredType(cell) == *value.type()->info;
    if (is_declared) cell.accepted = value.type();
  }
  cell.slot->value = std::move(value);
  CountWrite(cell);
}

void Overwrite(Cell& cell, Any value, const TypeInfo& info, StringView key) {
  const GateLock lock(*cell.gate);
  ConvertToDemanded(cell, value.value(), key);
  if (!cell.info.isStronglyTyped()) cell.info = info;
  cell.accepted = nullptr;
  cell.slot->value = std::move(value.value());
  CountWrite(cell);
}

namespace {

// Takes the value out of its slot for as long as it lives.
class CellLoan final : public Loan {
 public:
  explicit CellLoan(std::shared_ptr<Cell> cell) : cell_(std::move(cell)), lock_(*cell_->gate) {
    value.value() = std::move(cell_->slot->value);
  }
  ~CellLoan() override {
    if (cell_->demanded && !value.empty() && value.value().type() != cell_->demanded) {
      coppice::Value converted;
      if (converted.Parse(*cell_->demanded, value.value().Print())) value.value() = converted;
    }
    if (!cell_->info.isStronglyTyped() && !value.empty()) cell_->info = TypeInfo(value.type(), {});
    cell_->slot->value = std::move(value.value());
  }

 private:
  std::shared_ptr<Cell> cell_;
  GateLock lock_;
};

bool IsPrivate(StringView key) { return StartWith(key, '_'); }

}  // namespace
}  // namespace internal

using internal::Cell;
using internal::GateLock;

void Blackboard::addSubtreeRemapping(StringView internal, StringView external) {
  const std::unique_lock lock(mutex_);
  remapped_.emplace(internal, external);
}

const Blackboard* Blackboard::rootBlackboard() const {
  const Blackboard* board = this;
  while (const Ptr parent = board->parent_.lock()) board = parent.get();
  return board;
}
Blackboard* Blackboard::rootBlackboard() {
  return const_cast<Blackboard*>(std::as_const(*this).rootBlackboard());
}

std::shared_ptr<Cell> Blackboard::FindCell(StringView key) const {
  if (StartWith(key, '@')) return rootBlackboard()->FindCell(key.substr(1));
  const std::string name(key);
  std::string outside;
  {
    const std::shared_lock lock(mutex_);
    const auto found = cells_.find(name);
    if (found != cells_.end() && found->second->exists()) return found->second;
    const auto remapped = remapped_.find(name);
    if (remapped != remapped_.end()) {
      outside = remapped->second;
    } else if (autoremapping_ && !internal::IsPrivate(key)) {
      outside = name;
    }
  }
  const Ptr parent = parent_.lock();
  return parent && !outside.empty() ? parent->FindCell(outside) : nullptr;
}

std::shared_ptr<Cell> Blackboard::MakeCell(StringView key, const TypeInfo& info) {
  if (StartWith(key, '@')) return rootBlackboard()->MakeCell(key.substr(1), info);
  const std::string name(key);
  const std::unique_lock lock(mutex_);
  const auto found = cells_.find(name);
  if (found != cells_.end()) return found->second;
  const auto remapped = remapped_.find(name);
  const bool is_outside = remapped != remapped_.end();
  if (is_outside || (autoremapping_ && !internal::IsPrivate(key))) {
    const Ptr parent = parent_.lock();
    if (!parent) throw RuntimeError("Missing parent blackboard");
    return parent->MakeCell(is_outside ? remapped->second : name, info);
  }
  return cells_.emplace(name, std::make_shared<Cell>(info)).first->second;
}

std::shared_ptr<Cell> Blackboard::OwnCell(StringView key) {
  const std::unique_lock lock(mutex_);
  std::shared_ptr<Cell>& cell = cells_[std::string(key)];
  if (!cell) cell = std::make_shared<Cell>(TypeInfo());
  return cell;
}

Any Blackboard::Copy(const Cell& cell) {
  const GateLock lock(*cell.gate);
  Any value;
  value.value() = cell.slot->value;
  return value;
}

Timestamp Blackboard::StampOf(const Cell& cell) {
  const GateLock lock(*cell.gate);
  return {cell.slot->writes, cell.slot->stamp.time_since_epoch()};
}

std::shared_ptr<Blackboard::Entry> Blackboard::getEntry(const std::string& key) {
  const auto cell = FindCell(key);
  if (!cell) return nullptr;
  auto entry = std::make_shared<Entry>(cell->info);
  entry->value = Copy(*cell);
  entry->string_converter = cell->info.converter();
  const Timestamp stamp = StampOf(*cell);
  entry->sequence_id = stamp.seq;
  entry->stamp = stamp.time;
  return entry;
}
const std::shared_ptr<Blackboard::Entry> Blackboard::getEntry(const std::string& key) const {
  return const_cast<Blackboard&>(*this).getEntry(key);
}

const TypeInfo* Blackboard::entryInfo(const std::string& key) {
  const auto cell = FindCell(key);
  return cell ? &cell->info : nullptr;
}

AnyPtrLocked Blackboard::getAnyLocked(const std::string& key) {
  auto cell = FindCell(key);
  if (!cell) return {};
  return AnyPtrLocked(std::make_unique<internal::CellLoan>(std::move(cell)));
}
AnyPtrLocked Blackboard::getAnyLocked(const std::string& key) const {
  return const_cast<Blackboard&>(*this).getAnyLocked(key);
}

// A key that a tree uses stays, empty.
void Blackboard::unset(const std::string& key) {
  const std::unique_lock lock(mutex_);
  const auto found = cells_.find(key);
  if (found == cells_.end()) return;
  Cell& cell = *found->second;
  if (cell.slot == &cell.own) {
    cells_.erase(found);
    return;
  }
  const GateLock gate(*cell.gate);
  cell.slot->value.Reset();
  internal::CountWrite(cell);
  cell.info = TypeInfo();
  cell.is_declared = false;
  cell.accepted = nullptr;
}

void Blackboard::createEntry(const std::string& key, const TypeInfo& info) {
  if (StartWith(key, '@') && key.find('@', 1) != std::string::npos) {
    throw LogicError("Character '@' used multiple times in the key");
  }
  const auto cell = MakeCell(key, info);
  cell->is_declared = true;
  if (!cell->info.isStronglyTyped()) {
    cell->info = info;
  } else if (info.isStronglyTyped() && info.type() != cell->info.type()) {
    throw LogicError("Blackboard entry [", key,
                     "]: once declared, the type of a port shall not change. Previously declared "
                     "type [",
                     demangle(cell->info.type()), "], current type [", demangle(info.type()), "]");
  }
}

void Blackboard::debugMessage() const {
  const std::shared_lock lock(mutex_);
  for (const auto& [key, cell] : cells_) {
    if (!cell->exists()) continue;
    std::cout << key << " (" << internal::ShownType(*cell) << ")" << std::endl;
  }
  const Ptr parent = parent_.lock();
  for (const auto& [inner, outer] : remapped_) {
    std::cout << "[" << inner << "] remapped to port of parent tree [" << outer << "]";
    if (const auto cell = parent ? parent->FindCell(outer) : nullptr) {
      std::cout << " (" << internal::ShownType(*cell) << ")";
    }
    std::cout << std::endl;
  }
}

std::vector<StringView> Blackboard::getKeys() const {
  const std::shared_lock lock(mutex_);
  std::vector<StringView> keys;
  for (const auto& [key, cell] : cells_) {
    if (cell->exists()) keys.push_back(key);
  }
  return keys;
}

void Blackboard::clear() {
  for (const StringView key : getKeys()) unset(std::string(key));
}

void Blackboard::cloneInto(Blackboard& destination) const {
  std::vector<std::pair<std::string, std::shared_ptr<Cell>>> all;
  {
    const std::shared_lock lock(mutex_);
    all.assign(cells_.begin(), cells_.end());
  }
  for (const StringView view : destination.getKeys()) {
    const std::string key(view);
    const auto has = [&](const auto& pair) { return pair.first == key; };
    if (std::none_of(all.begin(), all.end(), has)) destination.unset(key);
  }
  for (const auto& [key, cell] : all) {
    if (!cell->exists()) continue;
    Any value = Copy(*cell);
    const auto to = destination.MakeCell(key, cell->info);
    const GateLock lock(*to->gate);
    to->info = cell->info;
    to->is_declared = cell->is_declared;
    to->accepted = nullptr;
    to->slot->value = std::move(value.value());
    internal::CountWrite(*to);
  }
}

nlohmann::json ExportBlackboardToJSON(const Blackboard& blackboard) {
  nlohmann::json json;
  for (const StringView view : blackboard.getKeys()) {
    const std::string key(view);
    const auto entry = blackboard.getEntry(key);
    if (entry) JsonExporter::get().toJson(entry->value, json[key]);
  }
  return json;
}

void ImportBlackboardFromJSON(const nlohmann::json& json, Blackboard& blackboard) {
  for (const auto& [key, value] : json.items()) {
    const auto entry = JsonExporter::get().fromJson(value);
    if (!entry || entry->first.empty()) continue;
    const auto cell = blackboard.MakeCell(key, entry->second);
    internal::Overwrite(*cell, entry->first, entry->second, key);
  }
}

}  // namespace BT
