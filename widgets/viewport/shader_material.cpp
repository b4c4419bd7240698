// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/shader_material.h"

#include <QUrl>
#include <QVector3D>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QColorMask>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

namespace mocapress {
namespace {

Qt3DRender::QShaderProgram* makeProgram(const QString& vertex, const QString& fragment,
                                        const QByteArray& defined) {
  const auto source = [&defined](const QString& file) {
    QByteArray text = Qt3DRender::QShaderProgram::loadSource(QUrl("qrc:/shaders/" + file));
    if (!defined.isEmpty())  // the #version line must come first
      text.insert(text.indexOf('\n') + 1, "#define " + defined + '\n');
    return text;
  };
  auto* program = new Qt3DRender::QShaderProgram;
  program->setVertexShaderCode(source(vertex + ".vert"));
  program->setFragmentShaderCode(source(fragment + ".frag"));
  return program;
}

Qt3DRender::QRenderPass* makePass(const ShaderPass& pass, Qt3DRender::QShaderProgram* program) {
  auto* key = new Qt3DRender::QFilterKey;
  key->setName(kPassKey);
  key->setValue(pass.name);
  auto* render_pass = new Qt3DRender::QRenderPass;
  render_pass->addFilterKey(key);
  render_pass->setShaderProgram(program);
  for (Qt3DRender::QRenderState* state : pass.states) render_pass->addRenderState(state);
  return render_pass;
}

}  // namespace

std::vector<ShaderPass> solidPasses() {
  return {{"shade", {}}};
}

std::vector<ShaderPass> ghostPasses() {
  auto* no_colour = new Qt3DRender::QColorMask;
  no_colour->setRedMasked(false);
  no_colour->setGreenMasked(false);
  no_colour->setBlueMasked(false);
  no_colour->setAlphaMasked(false);
  std::vector<Qt3DRender::QRenderState*> shade = translucent();
  auto* nearest = new Qt3DRender::QDepthTest;
  nearest->setDepthFunction(Qt3DRender::QDepthTest::LessOrEqual);
  shade.push_back(nearest);
  return {{"depth", {no_colour}}, {"shade", shade}};
}

ShaderMaterial::ShaderMaterial(const QString& vertex, const QString& fragment,
                               const std::vector<ShaderPass>& passes, QNode* parent,
                               const QByteArray& defined)
    : QMaterial(parent) {
  auto* technique = new Qt3DRender::QTechnique;
  Qt3DRender::QGraphicsApiFilter* api = technique->graphicsApiFilter();
  api->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
  api->setMajorVersion(3);
  api->setMinorVersion(2);
  api->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
  Qt3DRender::QShaderProgram* program = makeProgram(vertex, fragment, defined);
  for (const ShaderPass& pass : passes) technique->addRenderPass(makePass(pass, program));

  auto* effect = new Qt3DRender::QEffect;
  effect->addTechnique(technique);
  setEffect(effect);
}

void ShaderMaterial::set(const QString& uniform, const QVariant& value) {
  for (Qt3DRender::QParameter* parameter : parameters())
    if (parameter->name() == uniform) return parameter->setValue(value);
  addParameter(new Qt3DRender::QParameter(uniform, value));
}

void ShaderMaterial::setColour(const QString& uniform, const QColor& colour) {
  set(uniform, QVariant::fromValue(QVector3D(colour.redF(), colour.greenF(), colour.blueF())));
}

std::vector<Qt3DRender::QRenderState*> translucent() {
  using Arguments = Qt3DRender::QBlendEquationArguments;
  auto* arguments = new Arguments;
  arguments->setSourceRgb(Arguments::SourceAlpha);
  arguments->setDestinationRgb(Arguments::OneMinusSourceAlpha);
  arguments->setSourceAlpha(Arguments::One);
  arguments->setDestinationAlpha(Arguments::OneMinusSourceAlpha);
  auto* equation = new Qt3DRender::QBlendEquation;
  equation->setBlendFunction(Qt3DRender::QBlendEquation::Add);
  return {arguments, equation, new Qt3DRender::QNoDepthMask};
}

}  // namespace mocapress
