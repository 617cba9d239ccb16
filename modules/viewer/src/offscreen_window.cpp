// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "offscreen_window.h"

#include <pointmill/common/error.h>

#include <vtkVersionMacros.h>

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 4
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <memory>
#include <utility>
#endif

namespace pointmill::viewer {

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 4

// VTK takes EGL by itself from 9.4 on. Before, its windows are X11's, or draw into a
// context that somebody else has made.
namespace {

/// An OpenGL context without a surface, on whatever the machine draws with.
class EglContext {
public:
  EglContext()
  {
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>( // NOLINT
            eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay)
      display_ =
          platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
      throw Error("pictures need OpenGL, and EGL has none without a display: install "
                  "libegl1 and libgl1-mesa-dri");
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_NONE};
    constexpr EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglBindAPI(EGL_OPENGL_API) &&
        eglChooseConfig(display_, wanted, &config, 1, &count) && count > 0)
      context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT || !makeCurrent()) {
      release();
      throw Error("pictures need OpenGL 3.2, which EGL does not have here");
    }
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() { release(); }

  bool makeCurrent()
  {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  bool isCurrent() const { return eglGetCurrentContext() == context_; }

private:
  void release()
  {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT)
      eglDestroyContext(display_, context_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

class EglWindow : public vtkGenericOpenGLRenderWindow {
public:
  static EglWindow* New();
  vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow);

  /// @brief What it draws with; made first, since VTK's objects must not fail to be.
  void take(std::unique_ptr<EglContext> context) { context_ = std::move(context); }
  void MakeCurrent() override
  {
    if (context_)
      context_->makeCurrent();
  }
  bool IsCurrent() override { return context_ && context_->isCurrent(); }
  /// As VTK's, but that GLEW may miss an X display: OpenGL's functions are there then.
  void OpenGLInitContext() override
  {
    if (this->Initialized)
      return;
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY)
      throw Error("OpenGL's functions cannot be found");
    this->GlewInitValid = true;
    this->Initialized = true;
  }

protected:
  EglWindow()
  {
    this->SetOwnContext(1);
    this->SetReadyForRendering(true);
    this->SetOffScreenRendering(true);
  }
  ~EglWindow() override { this->Finalize(); }

private:
  std::unique_ptr<EglContext> context_;
};

vtkStandardNewMacro(EglWindow);

} // namespace

vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height)
{
  auto context = std::make_unique<EglContext>();
  auto window = vtkSmartPointer<EglWindow>::New();
  window->take(std::move(context));
  window->SetSize(width, height);
  return window;
}

#else

vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(true);
  window->SetSize(width, height);
  return window;
}

#endif

} // namespace pointmill::viewer
