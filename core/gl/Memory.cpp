#include "core/gl/Memory.h"

#include "core/gl/Context.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace taa::gl {

struct Allocation::Row {
  int objects = 0;
  std::size_t bytes = 0;
};

struct Allocation::Ledger {
  std::map<std::pair<std::string, StorageKind>, Row> rows;
  std::size_t bytes = 0, peak = 0;
  int failAfter = -1; ///< negative: never
};

const std::shared_ptr<Allocation::Ledger>& Allocation::ledger() {
  thread_local const auto ledger = std::make_shared<Ledger>();
  return ledger;
}

Allocation::Allocation(StorageKind kind, const std::string& label, std::size_t bytes, const std::string& what)
    : ledger_(ledger()), bytes_(bytes) {
  if (ledger_->failAfter == 0) throwOutOfMemory(what);
  if (ledger_->failAfter > 0) --ledger_->failAfter;
  row_ = &ledger_->rows[{label.substr(0, label.find(": ")), kind}];
  ++row_->objects;
  row_->bytes += bytes;
  ledger_->bytes += bytes;
  ledger_->peak = std::max(ledger_->peak, ledger_->bytes);
}

Allocation::~Allocation() {
  end();
}

void Allocation::end() {
  if (!ledger_) return;
  --row_->objects;
  row_->bytes -= bytes_;
  ledger_->bytes -= bytes_;
}

Allocation& Allocation::operator=(Allocation&& other) noexcept {
  if (this == &other) return *this;
  end();
  ledger_ = std::move(other.ledger_);
  row_ = other.row_;
  bytes_ = other.bytes_;
  return *this;
}

std::vector<MemoryUse> memoryUse() {
  std::vector<MemoryUse> uses;
  for (const auto& [key, row] : Allocation::ledger()->rows)
    if (row.objects > 0) uses.push_back({key.first, key.second, row.objects, row.bytes});
  std::ranges::stable_sort(uses, std::ranges::greater{}, &MemoryUse::bytes);
  return uses;
}

std::size_t memoryInUse() {
  return Allocation::ledger()->bytes;
}

std::size_t memoryPeak() {
  return Allocation::ledger()->peak;
}

void resetMemoryPeak() {
  Allocation::ledger()->peak = Allocation::ledger()->bytes;
}

void failAllocationsAfter(int count) {
  Allocation::ledger()->failAfter = count;
}

} // namespace taa::gl
