// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_objects.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace mocapress {
namespace {

std::string full_name(const FbxName& name) {
  return name.type + "::" + name.name;
}

}  // namespace

FbxProperties::FbxProperties(const FbxRecords& records, const FbxRecord& object,
                             const FbxProperties* defaults)
    : records_(&records), defaults_(defaults) {
  const FbxRecord* list = records.find(object, "Properties70");
  if (list == nullptr && (list = records.find(object, "Properties60")) != nullptr) first_value_ = 3;
  if (list == nullptr) return;
  for (const FbxRecord* p = records.first_child(*list); p != nullptr; p = records.next(*p))
    if (const auto name = records.value(*p, 0); name && name->kind == FbxValue::Kind::Text)
      own_.emplace(name->text, p);
}

const FbxRecord* FbxProperties::find(std::string_view name) const {
  for (const FbxProperties* of = this; of != nullptr; of = of->defaults_)
    if (const auto known = of->own_.find(name); known != of->own_.end()) return known->second;
  return nullptr;
}

std::vector<FbxValue> FbxProperties::values(std::string_view name) const {
  const FbxRecord* const record = find(name);
  if (record == nullptr) return {};
  const FbxProperties* of = this;
  while (!of->own_.contains(name)) of = of->defaults_;
  std::vector<FbxValue> values = of->records_->values(*record);
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(
                                                    std::min(of->first_value_, values.size())));
  return values;
}

double FbxProperties::number(std::string_view name, double otherwise) const {
  const std::vector<FbxValue> stated = values(name);
  const double number = stated.empty() ? otherwise : stated.front().number();
  return std::isfinite(number) ? number : otherwise;
}

Eigen::Vector3d FbxProperties::vector(std::string_view name,
                                      const Eigen::Vector3d& otherwise) const {
  const std::vector<FbxValue> stated = values(name);
  if (stated.size() < 3) return otherwise;
  const Eigen::Vector3d vector(stated[0].number(), stated[1].number(), stated[2].number());
  return vector.allFinite() ? vector : otherwise;
}

bool FbxProperties::is_custom(std::string_view name) const {
  const auto own = own_.find(name);
  if (own == own_.end()) return false;
  const auto flags = records_->value(*own->second, first_value_ - 1);
  return flags && flags->kind == FbxValue::Kind::Text && flags->text.find('U') != std::string::npos;
}

FbxObjects::FbxObjects(FbxRecords& records) : records_(records) {
  objects_.push_back({.type = "Model", .name = "RootNode", .kind = "Null"});
  by_id_.emplace(0, kScene);
  by_name_.emplace("Model::Scene", kScene);
  by_name_.emplace("Model::RootNode", kScene);
  read_templates();
  read_objects();
  read_connections();
}

void FbxObjects::read_templates() {
  const FbxRecord* const definitions = records_.find(records_.top(), "Definitions");
  if (definitions == nullptr) return;
  for (const FbxRecord* type = records_.first_child(*definitions); type != nullptr;
       type = records_.next(*type)) {
    const auto name = records_.value(*type, 0);
    const FbxRecord* const stated = records_.find(*type, "PropertyTemplate");
    if (name && stated != nullptr && name->kind == FbxValue::Kind::Text)
      templates_.emplace(std::string(name->text), FbxProperties(records_, *stated, nullptr));
  }
}

void FbxObjects::read_objects() {
  const bool by_name = records_.version() < 7000;
  const FbxRecord* settings = records_.find(records_.top(), "GlobalSettings");
  const FbxRecord* const list = records_.find(records_.top(), "Objects");
  const FbxRecord* record = list != nullptr ? records_.first_child(*list) : nullptr;
  for (; record != nullptr; record = records_.next(*record)) {
    if (record->name == "GlobalSettings" && settings == nullptr) settings = record;
    const std::vector<FbxValue> values = records_.values(*record);
    const std::size_t name_at = by_name ? 0 : 1;
    if (values.size() <= name_at || values[name_at].kind != FbxValue::Kind::Text) continue;
    const FbxName name = fbx_name(values[name_at].text);
    const std::size_t index = objects_.size();
    // Among objects with the same name or number, the first keeps it.
    if (by_name)
      by_name_.emplace(full_name(name), index);
    else if (values[0].kind == FbxValue::Kind::Integer)
      by_id_.emplace(values[0].integer, index);
    const bool has_kind =
        values.size() > name_at + 1 && values[name_at + 1].kind == FbxValue::Kind::Text;
    objects_.push_back({.type = std::string(record->name),
                        .name = name.name,
                        .kind = has_kind ? std::string(values[name_at + 1].text) : std::string(),
                        .record = record});
  }
  if (settings != nullptr) settings_ = FbxProperties(records_, *settings, nullptr);
}

std::optional<std::size_t> FbxObjects::resolve(const FbxValue& value) const {
  if (value.kind == FbxValue::Kind::Text) return named(full_name(fbx_name(value.text)));
  const auto known = by_id_.find(value.whole());
  return known != by_id_.end() ? std::optional(known->second) : std::nullopt;
}

std::optional<std::size_t> FbxObjects::named(std::string_view full) const {
  const auto known = by_name_.find(std::string(full));
  return known != by_name_.end() ? std::optional(known->second) : std::nullopt;
}

/// A connection is "OO", child, parent, or "OP", child, parent, property of the parent. Duplicates
/// count once; connections of missing objects are left out.
void FbxObjects::read_connections() {
  children_.resize(objects_.size());
  parents_.resize(objects_.size());
  const FbxRecord* const list = records_.find(records_.top(), "Connections");
  if (list == nullptr) return;
  std::set<std::tuple<std::size_t, std::size_t, std::string>> known;
  for (const FbxRecord* c = records_.first_child(*list); c != nullptr; c = records_.next(*c)) {
    const std::vector<FbxValue> values = records_.values(*c);
    if (values.size() < 3) continue;
    const auto child = resolve(values[1]);
    const auto parent = resolve(values[2]);
    if (!child || !parent || *child == *parent || *child == kScene) continue;
    std::string property;
    if (values.size() > 3 && values[3].kind == FbxValue::Kind::Text)
      property = std::string(values[3].text);
    if (!known.emplace(*child, *parent, property).second) {
      ++repeated_connections_;
      continue;
    }
    children_[*parent].push_back({*child, property});
    parents_[*child].push_back({*parent, property});
  }
}

std::optional<std::size_t> FbxObjects::child(std::size_t object, std::string_view type) const {
  for (const FbxLink& link : children_[object])
    if (is(link.object, type)) return link.object;
  return std::nullopt;
}

FbxProperties FbxObjects::properties(std::size_t object) const {
  const FbxObject& of = objects_[object];
  if (of.record == nullptr) return {};
  const auto defaults = templates_.find(of.type);
  return {records_, *of.record, defaults != templates_.end() ? &defaults->second : nullptr};
}

}  // namespace mocapress
