// SPDX-License-Identifier: MIT
#include "core/bank/bank.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <map>

#include "core/mocapress/python/bindings/clip.h"
#include "core/mocapress/python/bindings/instants.h"
#include "core/mocapress/python/bindings/text.h"
#include "core/runtime/mocapress_runtime.hpp"

namespace mocapress::python {
namespace {

using namespace py::literals;
using Path = std::filesystem::path;

std::uint32_t find(const BankFile& bank, const py::str& name) {
  try {
    return bank.find(from_str(name));
  } catch (const InputError& error) {
    throw py::key_error(error.what());
  }
}

bool contains(const BankFile& bank, const py::object& name) {
  if (!PyUnicode_Check(name.ptr())) return false;
  const std::string wanted = from_str(name);
  return runtime::find_clip(bank.bank(), wanted.data(), wanted.size()) >= 0;
}

py::list clip_names(const BankFile& bank) {
  py::list all;
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip)
    all.append(to_str(bank.entry(clip).name));
  return all;
}

std::shared_ptr<CodedClip> clip_of(const BankFile& bank, const py::str& name) {
  const std::uint32_t clip = find(bank, name);
  const py::gil_scoped_release without_gil;
  return std::make_shared<CodedClip>(bank.extract(bank.entry(clip)));
}

py::list tags(const BankFile& bank, const py::str& name) {
  py::list all;
  for (const std::string& tag : bank.tags(bank.entry(find(bank, name)))) all.append(to_str(tag));
  return all;
}

py::dict texts(const BankFile& bank) {
  py::dict all;
  for (const auto& [key, value] : bank.texts()) all[to_str(key)] = to_str(value);
  return all;
}

py::object sample_clip(const BankFile& bank, const py::str& name, const Doubles& seconds,
                       bool loop) {
  if (!bank.is_cooked())
    throw Error("the bank is packed: take the clip out of it, bank[name], and sample that");
  const mcpr_cooked* const clip = bank.cooked(bank.entry(find(bank, name)));
  check_wrap(loop, mcpr::describe(clip).loop_frames > 0);
  mcpr_sample_request request{};
  request.unit = MCPR_SECONDS;
  request.wrap = loop ? MCPR_LOOP : MCPR_CLAMP;
  const auto joints = static_cast<py::ssize_t>(mcpr::describe(clip).joints);
  constexpr py::ssize_t kFloats = sizeof(mcpr_transform) / sizeof(float);
  const py::array_t<float> transforms =
      at_instants(seconds, joints, kFloats, [&](double instant, float* out) {
        mcpr_result result;
        mcpr_sample(clip, &request, instant, out, &result);
        if (result.status != MCPR_OK) throw Error(result.message);
      });
  // Drops the last float of each transform, which is padding.
  return transforms[py::make_tuple(py::ellipsis(), py::slice(0, kFloats - 1, 1))];
}

void make(const Path& path, const std::map<std::string, Path>& clips, bool cooked, bool learn,
          const std::vector<std::string>& clip_tags,
          const std::map<std::string, std::string>& bank_texts) {
  BankOptions options{.form = cooked ? runtime::BankForm::Cooked : runtime::BankForm::Packed,
                      .tags = clip_tags,
                      .texts = {bank_texts.begin(), bank_texts.end()},
                      .learn = learn};
  std::vector<BankSource> sources;
  for (const auto& [name, file] : clips) sources.push_back({name, file, ""});
  make_bank(path, std::move(sources), options);
}

}  // namespace

void bind_bank(py::module_& module) {
  py::class_<BankFile>(module, "Bank",
                       "Many clips in one .mcpk file, by name. All of the file is in memory, and "
                       "checked when it is opened.")
      .def(py::init<const Path&>(), py::call_guard<py::gil_scoped_release>(), "path"_a,
           "Raises InputError.")
      .def_static("make", &make, py::call_guard<py::gil_scoped_release>(), "path"_a, "clips"_a,
                  py::kw_only(), "cooked"_a = false, "learn"_a = false,
                  "tags"_a = std::vector<std::string>(), "texts"_a = py::dict(),
                  "Writes a bank, whole or not at all. clips: {name: path of a .mcpr}. cooked: for "
                  "engines that sample in place. learn: smaller from some hundred clips on. tags: "
                  "of every clip. texts: of the bank. Raises InputError and WriteError.")
      .def_property_readonly("is_cooked", &BankFile::is_cooked,
                             "True if engines can sample its clips where they lie.")
      .def_property_readonly("names", &clip_names, "The names of all clips, in order.")
      .def_property_readonly("texts", &texts, "What the bank says about itself, by name.")
      .def("tags", &tags, "name"_a, "Raises KeyError.")
      .def("sample", &sample_clip, "name"_a, "seconds"_a, py::kw_only(), "loop"_a = false,
           "Poses of a clip in a cooked bank, sampled where it lies: float32, as Clip.sample() "
           "gives them. Raises KeyError, and Error for a packed bank.")
      .def("__getitem__", &clip_of, "name"_a,
           "The Clip that was put in. Raises KeyError, and InputError for a cooked bank.")
      .def("__repr__",
           [](const BankFile& bank) {
             return std::string("<mocapress.Bank: ") +
                    (bank.is_cooked() ? "cooked, " : "packed, ") + std::to_string(bank.clips()) +
                    " clips>";
           })
      .def("__len__", &BankFile::clips)
      .def("__contains__", &contains, "name"_a)
      .def("__iter__", [](const BankFile& bank) { return py::iter(clip_names(bank)); });
}

}  // namespace mocapress::python
