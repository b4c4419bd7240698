// SPDX-License-Identifier: MIT
// The part of the C interface that blends poses.
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/blending.h"
#include "core/runtime/pose/conventions.h"

namespace mocapress::runtime {
namespace {

constexpr mcpr_result no_blend(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

bool is_known(const mcpr_convention* convention) {
  return convention == nullptr || is_convention(*convention);
}

mcpr_result check_form(const mcpr_pose_form* form) {
  if (form == nullptr) return no_blend("no form of the poses");
  return is_known(form->convention) ? kOk : no_blend("an impossible convention");
}

mcpr_result check_blend(const mcpr_pose_form* form, const mcpr_weighted_pose* poses,
                        std::uint32_t count, const mcpr_transform* out) {
  if (const mcpr_result result = check_form(form); failed(result)) return result;
  if (poses == nullptr || count == 0 || out == nullptr)
    return no_blend("no poses to blend, or no output");
  for (std::uint32_t i = 0; i < count; ++i)
    if (poses[i].pose == nullptr || !(poses[i].weight >= 0))
      return no_blend("no pose, or a weight below zero");
  return kOk;
}

constexpr const char* kNoShare = "a weight that is not 0 to 1";

}  // namespace
}  // namespace mocapress::runtime

namespace runtime = mocapress::runtime;

mcpr_status mcpr_blend(const mcpr_pose_form* form, const mcpr_weighted_pose* poses, uint32_t count,
                       mcpr_transform* out, mcpr_result* report) {
  const mcpr_result result = runtime::check_blend(form, poses, count, out);
  if (runtime::failed(result)) return runtime::tell(report, result);
  return runtime::tell(report, runtime::blend(poses, count, form->joints, out)
                                   ? runtime::kOk
                                   : runtime::no_blend("a weight that is not 0 to 10^6"));
}

mcpr_status mcpr_blend_layer(const mcpr_pose_form* form, const mcpr_weighted_pose* layer,
                             mcpr_transform* pose, mcpr_result* report) {
  const mcpr_result result = runtime::check_blend(form, layer, 1, pose);
  if (runtime::failed(result)) return runtime::tell(report, result);
  return runtime::tell(report, runtime::blend_layer(*layer, form->joints, pose)
                                   ? runtime::kOk
                                   : runtime::no_blend(runtime::kNoShare));
}

mcpr_status mcpr_pose_difference(const mcpr_pose_form* form, const mcpr_transform* pose,
                                 const mcpr_transform* base, mcpr_transform* out,
                                 mcpr_result* report) {
  const mcpr_result result = runtime::check_form(form);
  if (runtime::failed(result)) return runtime::tell(report, result);
  if (pose == nullptr || base == nullptr || out == nullptr)
    return runtime::tell(report, runtime::no_blend("no pose, no base, or no output"));
  runtime::take_difference(runtime::PoseSpace(form->convention), pose, base, form->joints, out);
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_blend_additive(const mcpr_pose_form* form, const mcpr_weighted_pose* difference,
                                mcpr_transform* pose, mcpr_result* report) {
  const mcpr_result result = runtime::check_blend(form, difference, 1, pose);
  if (runtime::failed(result)) return runtime::tell(report, result);
  const runtime::PoseSpace space(form->convention);
  return runtime::tell(report, runtime::add_difference(space, *difference, form->joints, pose)
                                   ? runtime::kOk
                                   : runtime::no_blend(runtime::kNoShare));
}

mcpr_status mcpr_split_root(const mcpr_convention* convention, mcpr_transform* root,
                            mcpr_transform* ground, mcpr_result* report) {
  if (!runtime::is_known(convention))
    return runtime::tell(report, runtime::no_blend("an impossible convention"));
  if (root == nullptr || ground == nullptr)
    return runtime::tell(report, runtime::no_blend("no root, or no output"));
  runtime::split_root(runtime::PoseSpace(convention), *root, *ground);
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_make_mirror(const mcpr_pose_form* form, const mcpr_transform* bind,
                             const int16_t* parents, const uint16_t* partners, int axis,
                             mcpr_mirror_joint* mirror, mcpr_result* report) {
  const mcpr_result result = runtime::check_form(form);
  if (runtime::failed(result)) return runtime::tell(report, result);
  if (bind == nullptr || parents == nullptr || partners == nullptr || mirror == nullptr)
    return runtime::tell(report,
                         runtime::no_blend("no bind pose, parents or partners, or no output"));
  if (axis < 0 || axis > 2) return runtime::tell(report, runtime::no_blend("no such axis"));
  if (!runtime::are_parents(parents, form->joints))
    return runtime::tell(report, runtime::no_blend("a parent that does not come before its joint"));
  if (!runtime::are_partners(partners, parents, form->joints))
    return runtime::tell(
        report, runtime::no_blend("partners that are not mutual, or do not hang from partners"));
  runtime::make_mirror(runtime::PoseSpace(form->convention), bind, parents, partners, axis,
                       form->joints, mirror);
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpr_mirror_pose(const mcpr_pose_form* form, const mcpr_mirror_joint* mirror, int axis,
                             const mcpr_transform* pose, mcpr_transform* out, mcpr_result* report) {
  const mcpr_result result = runtime::check_form(form);
  if (runtime::failed(result)) return runtime::tell(report, result);
  if (mirror == nullptr || pose == nullptr || out == nullptr || axis < 0 || axis > 2)
    return runtime::tell(report,
                         runtime::no_blend("no mirror, no pose, no output, or no such axis"));
  for (std::uint32_t j = 0; j < form->joints; ++j)
    if (mirror[j].partner >= form->joints)
      return runtime::tell(report, runtime::no_blend("a partner that the pose does not have"));
  runtime::mirror_pose(runtime::PoseSpace(form->convention), mirror, axis, pose, form->joints, out);
  return runtime::tell(report, runtime::kOk);
}
