#include "gl.h"

#include <stdexcept>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace tread::demo {
namespace {

GLuint compile(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::string words(2000, ' ');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error("tread_demo: OpenGL does not take a shader: " + words);
}

}  // namespace

// ---- Program ----

Program::Program(const char* vertex, const char* fragment) : id_(glCreateProgram()) {
    const GLuint shaders[] = {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)};
    for (GLuint shader : shaders) glAttachShader(id_, shader);
    glLinkProgram(id_);
    GLint good = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &good);
    for (GLuint shader : shaders) glDeleteShader(shader);
    if (!good) throw std::runtime_error("tread_demo: OpenGL does not link a program");
}

void Program::set(const char* name, const Matrix& value) const {
    glUniformMatrix4fv(glGetUniformLocation(id_, name), 1, GL_FALSE, value.data());
}
void Program::set(const char* name, const Eigen::Vector3f& value) const {
    glUniform3fv(glGetUniformLocation(id_, name), 1, value.data());
}
void Program::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(id_, name), value);
}

// ---- Drawable ----

Drawable::Drawable(std::initializer_list<GLint> inputs) {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    for (const GLint numbers : inputs) corner_ += static_cast<std::size_t>(numbers) * sizeof(float);
    GLuint place = 0;
    std::size_t offset = 0;
    for (const GLint numbers : inputs) {
        glEnableVertexAttribArray(place);
        glVertexAttribPointer(place++, numbers, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(corner_),
                              reinterpret_cast<const void*>(offset));
        offset += static_cast<std::size_t>(numbers) * sizeof(float);
    }
}

Drawable::~Drawable() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void Drawable::load(const void* corners, std::size_t bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), corners, GL_DYNAMIC_DRAW);
    count_ = static_cast<GLsizei>(bytes / corner_);
}

void Drawable::draw() const {
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, count_);
}

// ---- Canvas and shadow map ----

Canvas::Canvas(int width, int height, int samples) : width_(width), height_(height) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("tread_demo: OpenGL gives no picture of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " to draw into");
}

Canvas::~Canvas() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colour_);
    glDeleteRenderbuffers(1, &depth_);
}

void Canvas::use() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void Canvas::copyTo(GLuint framebuffer) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

ShadowMap::ShadowMap() {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

ShadowMap::~ShadowMap() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void ShadowMap::use() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, kSize, kSize);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void savePng(const Canvas& canvas, const std::filesystem::path& file) {
    constexpr int kChannels = 3;
    std::vector<unsigned char> pixels(static_cast<std::size_t>(canvas.width()) *
                                      static_cast<std::size_t>(canvas.height()) * kChannels);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.framebuffer());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, canvas.width(), canvas.height(), GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    stbi_flip_vertically_on_write(1);
    const int row = canvas.width() * kChannels;
    if (!stbi_write_png(file.string().c_str(), canvas.width(), canvas.height(), kChannels, pixels.data(), row))
        throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace tread::demo
