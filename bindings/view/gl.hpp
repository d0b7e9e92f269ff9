#pragma once
// What OpenGL gives and must be given back, each as an object.
#include <epoxy/gl.h>

#include <Eigen/Core>
#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// A vertex and a fragment shader by their names in assets/shaders, after definitions and the common texts. Where this
/// OpenGL refuses them, that is told, and what they draw is left out.
class ShaderProgram {
 public:
  ShaderProgram(const std::string& name, std::initializer_list<const char*> common, const std::string& definitions);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  bool usable() const { return id_ != 0; }
  void use() const { glUseProgram(id_); }
  void set(const char* name, float value) const { glUniform1f(place(name), value); }
  void set(const char* name, int value) const { glUniform1i(place(name), value); }
  void set(const char* name, float x, float y) const { glUniform2f(place(name), x, y); }
  void set(const char* name, Vec3 v) const {
    glUniform3f(place(name), static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
  }
  void set(const char* name, const Eigen::Matrix3f& m) const { glUniformMatrix3fv(place(name), 1, GL_FALSE, m.data()); }
  void set(const char* name, const Eigen::Matrix4f& m) const { glUniformMatrix4fv(place(name), 1, GL_FALSE, m.data()); }
  void set(const char* name, const std::array<std::array<float, 2>, 4>& places) const {
    glUniform2fv(place(name), 4, places[0].data());
  }

 private:
  void link(const std::string& name, const std::string& head);
  GLint place(const char* name) const { return glGetUniformLocation(id_, name); }
  GLuint id_ = 0;
};

/// NeighbourList of floats that are sent anew for each picture.
class FloatRows {
 public:
  /// Numbers of floats of the attributes 0, 1, …; `each_instance` steps them by instance rather than by vertex.
  FloatRows(std::initializer_list<int> attributes, bool each_instance);
  ~FloatRows();
  FloatRows(const FloatRows&) = delete;
  FloatRows& operator=(const FloatRows&) = delete;

  template <class Row>
  void send(const std::vector<Row>& rows) {
    send(rows.data(), rows.size() * sizeof(Row));
    count_ = static_cast<GLsizei>(rows.size());
  }
  GLsizei count() const { return count_; }
  /// Draws them all: the rows as corners, or each as so many corners.
  void draw(const ShaderProgram& program, GLenum shape, GLsizei corners = 0) const;

 private:
  void send(const void* data, std::size_t bytes);
  bool each_instance_;
  GLuint array_ = 0, buffer_ = 0;
  GLsizei count_ = 0;
};

/// A picture to draw into. One for colours is a renderbuffer, the others are textures.
class Target {
 public:
  enum class Format {
    color,    ///< RGBA
    shade,    ///< one channel, 0 … 1, even between pixels
    height,   ///< one of any size
    shelter,  ///< two of any size
  };
  enum class Depth { none, kept, texture };  ///< a texture only without samples
  Target(int width, int height, int samples, Format format, Depth depth = Depth::none);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  void bind() const;
  /// What was drawn, as the texture of a unit.
  void bind_texture(int unit) const;
  void bind_depths(int unit) const;
  GLuint framebuffer() const { return framebuffer_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

 private:
  void add_color(Format format);
  void add_depth();
  int width_, height_, samples_;
  bool texture_;
  Depth depth_kind_;
  GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

}  // namespace pantin
