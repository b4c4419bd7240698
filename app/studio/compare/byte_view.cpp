// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/byte_view.h"

#include <algorithm>
#include <cmath>

#include "app/studio/document/session.h"
#include "core/motion/body_part.h"
#include "widgets/models/byte_cost_model.h"
#include "widgets/models/display_names.h"
#include "widgets/timeline/byte_strip.h"
#include "widgets/timeline/playback.h"

namespace mocapress {
namespace {

constexpr double kSliceSeconds = 0.1;
constexpr double kRelaxed = 2;  // factor on the error
constexpr double kMore = 1.1;   // factors on the bytes
constexpr double kFewer = 0.9;

// Number of joints with the most bytes that get lines of their own, beside the body parts.
constexpr int kDearest = 2;

}  // namespace

ByteView::ByteView(Session* session, Playback* playback, ByteStrip* strip, ByteCostModel* model,
                   BytesPanel* panel, QObject* parent)
    : QObject(parent), session_(session), strip_(strip), model_(model), panel_(panel) {
  Document* document = &session->document();
  connect(document, &Document::clipChanged, this, [this] {
    shown_ = nullptr;
    dividing_.abandon();
    forgetSlopes();
    show(nullptr);
    divide();
  });
  connect(document, &Document::decodedChanged, this, &ByteView::divide);
  connect(document, &Document::currentJointChanged, panel_,
          [this, document] { panel_->setCurrentJoint(document->currentJoint()); });
  connect(panel_, &BytesPanel::currentJointChanged, document, &Document::setCurrentJoint);
  connect(strip_, &ByteStrip::chosen, this, [playback, document](int frame, int joint) {
    playback->seek(frame);
    document->setCurrentJoint(joint);
  });
  connect(panel_, &BytesPanel::measureRequested, this, &ByteView::measure);
  connect(panel_, &BytesPanel::applyRequested, this, [this](int slope) {
    // Copied, since the new settings remove all lines.
    const EncodeSettings options = slopes_[static_cast<std::size_t>(slope)].settings;
    session_->setOptions(options);
  });
  connect(session, &Session::recompressing, this, &ByteView::forgetSlopes);
  connect(&finder_, &SlopeFinder::found, this, &ByteView::add);
  connect(&finder_, &SlopeFinder::ended, this, &ByteView::showState);
  connect(session, &Session::settled, this, &ByteView::showState);
  showState();
}

void ByteView::divide() {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  showState();
  // Skips drafts: they follow one another faster than their bytes could be divided.
  if (decoded == shown_ || (decoded && (!document.final() || decoded->file.empty()))) return;
  shown_ = decoded;
  dividing_.abandon();
  forgetSlopes();
  if (!decoded) return show(nullptr);
  const int slice =
      std::max(1, static_cast<int>(std::lround(kSliceSeconds * document.sampleRate())));
  dividing_.start(
      [decoded, slice](const Job&) {
        return std::make_shared<const ByteCosts>(byte_costs(decoded->file, slice));
      },
      [this](const std::shared_ptr<const ByteCosts>& costs) { show(costs); },
      [this](const QString&) { show(nullptr); });
}

void ByteView::show(const std::shared_ptr<const ByteCosts>& costs) {
  const Document& document = session_->document();
  std::vector<QString> names = document.landmarkNames();  // landmark j is joint j
  strip_->setCosts(costs, names, document.frames());
  model_->setCosts(costs, std::move(names));
  panel_->setCurrentJoint(document.currentJoint());
}

void ByteView::forgetSlopes() {
  finder_.abandon();
  slopes_.clear();
  rows_.clear();
  panel_->setSlopes(rows_);
  showState();
}

bool ByteView::measurable() const {
  const Document& document = session_->document();
  const DecodedPtr& decoded = document.decoded();
  return document.original() && decoded && decoded->distortion && document.final() &&
         decoded->distortion->distances.size() > 0 &&
         document.options().method == Method::ClosedLoop;
}

void ByteView::showState() {
  panel_->setState(finder_.busy(), measurable());
}

void ByteView::measure() {
  if (!measurable()) return;
  const Document& document = session_->document();
  const Skeleton& skeleton = document.original()->motion().skeleton;
  const DecodedClip& decoded = *document.decoded();
  forgetSlopes();
  titles_.clear();
  task_ = {document.original()->encoder,
           document.options(),
           standing_of(skeleton, *decoded.distortion, document.options().weighting,
                       decoded.compressed.motion_bytes()),
           {}};
  const auto add = [&](const QString& title, std::vector<int> joints, double times) {
    titles_.push_back(title);
    task_.changes.push_back({std::move(joints), times});
  };
  std::vector<int> of_parts;
  for (const BodyPart part : kBodyParts) {
    std::vector<int> joints = joints_of(skeleton, part);
    of_parts.insert(of_parts.end(), joints.begin(), joints.end());
    if (!joints.empty())
      add(tr("%1: error × 2").arg(displayName(part)), std::move(joints), kRelaxed);
  }
  std::vector<std::pair<double, int>> dearest;
  for (int row = 0; row < model_->rowCount(); ++row)
    if (const int joint = model_->jointOf(row);
        joint > 0 && std::find(of_parts.begin(), of_parts.end(), joint) == of_parts.end())
      dearest.emplace_back(
          model_->index(row, ByteCostModel::Bytes).data(ByteCostModel::kSortRole).toDouble(),
          joint);
  std::sort(dearest.rbegin(), dearest.rend());
  dearest.resize(std::min<std::size_t>(dearest.size(), kDearest));
  const std::vector<QString> names = document.landmarkNames();
  for (const auto& [bytes, joint] : dearest)
    add(tr("%1: error × 2").arg(names[static_cast<std::size_t>(joint)]), {joint}, kRelaxed);
  add(tr("10 % more bytes"), {}, kMore);
  add(tr("10 % fewer bytes"), {}, kFewer);
  finder_.start(task_);
  showState();
}

void ByteView::add(int change, const Slope& slope) {
  const auto index = static_cast<std::size_t>(change);
  const std::vector<int>& joints = task_.changes[index].joints;
  const auto error = [&](const Standing& standing) {
    return joints.empty() ? standing.eps_cm : standing.cm_of(joints);
  };
  slopes_.push_back(slope);
  rows_.push_back({titles_[index], slope.standing.bytes - task_.now.bytes, error(task_.now),
                   error(slope.standing)});
  panel_->setSlopes(rows_);
}

}  // namespace mocapress
