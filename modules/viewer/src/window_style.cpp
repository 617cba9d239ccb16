// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "window_style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace pointmill::viewer {

vtkStandardNewMacro(WindowStyle);

void WindowStyle::OnKeyDown()
{
  const char* key = Interactor->GetKeySym();
  taken_ =
      key && on_key &&
      on_key(key, Interactor->GetShiftKey() != 0, Interactor->GetControlKey() != 0);
  if (!taken_)
    PCLVisualizerInteractorStyle::OnKeyDown();
}

void WindowStyle::OnChar()
{
  if (!taken_) // PCL looks at characters once more
    PCLVisualizerInteractorStyle::OnChar();
}

void WindowStyle::OnTimer()
{
  if (on_tick)
    on_tick();
}

} // namespace pointmill::viewer
