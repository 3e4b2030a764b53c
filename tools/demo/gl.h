// The little of OpenGL 3.3 that the demo needs: programs, meshes, pictures to draw into.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Core>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "mesh.h"

namespace tread::demo {

using Matrix = Eigen::Matrix4f;

class Program {
public:
    Program(const char* vertex, const char* fragment);  // std::runtime_error with OpenGL's words
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { glDeleteProgram(id_); }

    void use() const { glUseProgram(id_); }
    void set(const char* name, const Matrix& value) const;
    void set(const char* name, const Eigen::Vector3f& value) const;
    void set(const char* name, int value) const;

private:
    GLuint id_;
};

// Triangles on the graphics card.
class Drawable {
public:
    // Each corner is so many numbers for each of the shader's inputs in turn.
    explicit Drawable(std::initializer_list<GLint> inputs);
    explicit Drawable(const Mesh& mesh = {}) : Drawable({3, 3, 3, 1}) { load(mesh); }
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;
    ~Drawable();

    template <class Corner>
    void load(const std::vector<Corner>& corners) {
        load(corners.data(), corners.size() * sizeof(Corner));
    }
    void draw() const;

private:
    void load(const void* corners, std::size_t bytes);

    GLuint array_ = 0, buffer_ = 0;
    std::size_t corner_ = 0;  // bytes
    GLsizei count_ = 0;
};

// A picture in memory, smoothed by samples or not.
class Canvas {
public:
    Canvas(int width, int height, int samples);
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
    ~Canvas();

    void use() const;
    void copyTo(GLuint framebuffer) const;
    GLuint framebuffer() const { return framebuffer_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_, height_;
    GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

// How deep the light reaches.
class ShadowMap {
public:
    static constexpr int kSize = 2048;
    ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;
    ~ShadowMap();

    void use() const;
    GLuint texture() const { return texture_; }

private:
    GLuint framebuffer_ = 0, texture_ = 0;
};

// PNG of a canvas without samples; std::runtime_error when it cannot be written.
void savePng(const Canvas& canvas, const std::filesystem::path& file);

}  // namespace tread::demo
