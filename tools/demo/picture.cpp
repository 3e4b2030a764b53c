#include "picture.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "rate_slider.h"
#include "shaders.h"

namespace tread::demo {
namespace {

using Eigen::Vector3f;

constexpr Colour kStockPaint{0.16F, 0.30F, 0.62F}, kTreadPaint{0.78F, 0.12F, 0.08F};
constexpr Colour kWhite{0.95F, 0.96F, 0.97F}, kGrey{0.72F, 0.75F, 0.78F};
constexpr float kNear = 0.3F, kFar = 900, kFieldOfView = 0.9F;  // m, rad
constexpr float kLightReach = 32;                               // m, to each side of the car
constexpr int kSamples = 4;
constexpr float kSliderPanel = 14;  // pixels, beside the slider

Vector3f floats(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Matrix matrixOf(const btTransform& t) {
    Matrix m = Matrix::Identity();
    for (int k = 0; k < 3; ++k) m.col(k).head<3>() = floats(t.getBasis().getColumn(k));
    m.col(3).head<3>() = floats(t.getOrigin());
    return m;
}

Matrix lookAt(const Vector3f& eye, const Vector3f& target, const Vector3f& up) {
    const Vector3f back = (eye - target).normalized(), right = up.cross(back).normalized();
    Matrix m = Matrix::Identity();
    m.row(0).head<3>() = right;
    m.row(1).head<3>() = back.cross(right);
    m.row(2).head<3>() = back;
    m.col(3).head<3>() = -m.topLeftCorner<3, 3>() * eye;
    return m;
}

Matrix perspective(float aspect) {
    const float f = 1 / std::tan(0.5F * kFieldOfView);
    Matrix m = Matrix::Zero();
    m(0, 0) = f / aspect;
    m(1, 1) = f;
    m(2, 2) = (kFar + kNear) / (kNear - kFar);
    m(2, 3) = 2 * kFar * kNear / (kNear - kFar);
    m(3, 2) = -1;
    return m;
}

// Parallel light on the surroundings of a place.
Matrix lightAt(const Vector3f& centre, const Vector3f& sun) {
    Matrix m = lookAt(centre + 60 * sun, centre, Vector3f::UnitY());
    const Vector3f scale(1 / kLightReach, 1 / kLightReach, -1.0F / 60);
    m.topRows<3>() = scale.asDiagonal() * m.topRows<3>();
    m(2, 3) -= 1;
    return m;
}

}  // namespace

Picture::Picture(const Track& track, const std::filesystem::path& font)
    : depth_(kDepthVertex, kDepthFragment),
      scene_(kSceneVertex, kSceneFragment),
      sky_(kSkyVertex, kSkyFragment),
      text_(font),
      ground_(groundMesh()),
      wheel_(wheelMesh()),
      stock_body_(bodyMesh(kStockPaint)),
      tread_body_(bodyMesh(kTreadPaint)) {
    for (const Block& block : track.blocks()) blocks_.push_back(std::make_unique<Drawable>(blockMesh(block)));
    glGenVertexArrays(1, &nothing_);
}

void Picture::drawThings(const Program& program, const Frame& frame) const {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        program.set("model", matrixOf(frame.track.blocks()[i].body->getWorldTransform()));
        blocks_[i]->draw();
    }
    const Matrix chassis = matrixOf(frame.pose.chassis);
    program.set("model", chassis);
    (frame.car.kind() == Kind::stock ? stock_body_ : tread_body_).draw();
    for (int i = 0; i < 4; ++i) {
        const WheelPose& pose = frame.pose.wheels[static_cast<std::size_t>(i)];
        program.set("model", Matrix(chassis * matrixOf(frame.car.wheelInChassis(i, pose))));
        wheel_.draw();
    }
}

void Picture::draw(const Frame& frame, int width, int height) {
    if (!plain_ || plain_->width() != width || plain_->height() != height) {
        smooth_.emplace(width, height, kSamples);
        plain_.emplace(width, height, 0);
    }
    marks_.load(frame.marks);
    arrows_.load(frame.arrows);
    glEnable(GL_DEPTH_TEST);

    // ---- What the sun sees ----
    const Vector3f sun = Vector3f(-0.45F, 0.75F, -0.35F).normalized();
    const Matrix light = lightAt(floats(frame.pose.chassis.getOrigin()), sun);
    shadow_.use();
    depth_.use();
    depth_.set("light", light);
    drawThings(depth_, frame);

    // ---- What the eye sees ----
    smooth_->use();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Vector3f eye = floats(frame.eye);
    const Matrix view = perspective(static_cast<float>(width) / static_cast<float>(height)) *
                        lookAt(eye, floats(frame.target), Vector3f::UnitY());
    scene_.use();
    scene_.set("view", view);
    scene_.set("light", light);
    scene_.set("eye", eye);
    scene_.set("sun", sun);
    scene_.set("shadow", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shadow_.texture());
    scene_.set("model", Matrix(Matrix::Identity()));
    ground_.draw();
    marks_.draw();
    drawThings(scene_, frame);
    sky_.use();
    sky_.set("back", Matrix(view.inverse()));
    glBindVertexArray(nothing_);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    // ---- Arrows and text over everything ----
    glClear(GL_DEPTH_BUFFER_BIT);
    scene_.use();
    scene_.set("model", Matrix(Matrix::Identity()));
    arrows_.draw();
    drawText(frame, view, width, height);
    smooth_->copyTo(plain_->framebuffer());
}

void Picture::addSigns(const Frame& frame, const Matrix& view, int width, int height) {
    constexpr float kSignsReach = 75;                       // m
    constexpr float kPanelRight = 330, kPanelBottom = 220;  // pixels: of the text in the corner
    for (const Sign& sign : frame.track.signs()) {
        const Vector3f at = floats(sign.at);
        const Eigen::Vector4f seen = view * Eigen::Vector4f(at.x(), at.y(), at.z(), 1);
        if (seen.w() < 5 || seen.w() > kSignsReach) continue;
        const float x = 0.5F * static_cast<float>(width) * (1 + seen.x() / seen.w());
        const float y = 0.5F * static_cast<float>(height) * (1 - seen.y() / seen.w());
        const float half = 0.5F * text_.width(sign.text, 0.9F);
        if (x - half < kPanelRight && y < kPanelBottom) continue;
        if (x + half > RateSlider(width).left() - kSliderPanel && y < RateSlider::kBottom + 18) continue;
        text_.addPanel(x - half - 6, y - 18, x + half + 6, y + 6);
        text_.add(x - half, y, sign.text, kWhite, 0.9F);
    }
}

void Picture::addRateSlider(double rate, int width) {
    const RateSlider slider(width);
    const float left = slider.left(), right = slider.right(), at = slider.placeOf(rate), middle = RateSlider::kMiddle;
    text_.addPanel(left - kSliderPanel, RateSlider::kTop, right + kSliderPanel, RateSlider::kBottom);
    text_.add(left, RateSlider::kTop + 24, "steps per second: " + std::to_string(static_cast<int>(rate)), kWhite);
    text_.addBar(left, middle - 2, right, middle + 2, kGrey);
    text_.addBar(at - RateSlider::kHalfHandle, middle - RateSlider::kHalfHeight, at + RateSlider::kHalfHandle,
                 middle + RateSlider::kHalfHeight, kWhite);
}

void Picture::drawText(const Frame& frame, const Matrix& view, int width, int height) {
    addSigns(frame, view, width, height);
    addRateSlider(frame.rate, width);
    constexpr float kLine = 23, kLeft = 28;
    float widest = text_.width(frame.headline, 1.3F);
    for (const std::string& line : frame.lines) widest = std::max(widest, text_.width(line));
    text_.addPanel(kLeft - 12, 14, kLeft + widest + 14, 60 + kLine * static_cast<float>(frame.lines.size()));
    text_.add(kLeft, 42, frame.headline,
              frame.car.kind() == Kind::stock ? Colour{0.55F, 0.72F, 1} : Colour{1, 0.5F, 0.4F}, 1.3F);
    float y = 72;
    for (const std::string& line : frame.lines) {
        text_.add(kLeft, y, line, kWhite);
        y += kLine;
    }
    const auto help_lines = static_cast<float>(frame.help.size());
    y = static_cast<float>(height) - 14 - 20 * (help_lines - 1);
    if (!frame.help.empty()) {
        float longest = 0;
        for (const std::string& line : frame.help) longest = std::max(longest, text_.width(line, 0.85F));
        text_.addPanel(kLeft - 12, y - 22, kLeft + longest + 14, static_cast<float>(height) - 6);
    }
    for (const std::string& line : frame.help) {
        text_.add(kLeft, y, line, kGrey, 0.85F);
        y += 20;
    }
    text_.draw(width, height);
}

}  // namespace tread::demo
