#include "view/png_vtk.hpp"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <string_view>

#include "trace/output_file.hpp"

namespace fingerpad {

Pixels pixels_of(vtkRenderWindow* window) {
  Pixels pixels;
  vtkNew<vtkUnsignedCharArray> rgb;
  const int* size = window->GetSize();
  pixels.width = size[0];
  pixels.height = size[1];
  window->GetPixelData(0, 0, pixels.width - 1, pixels.height - 1, 0, rgb);
  pixels.rgb.assign(rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  return pixels;
}

void write_png(vtkRenderWindow* window, const std::string& path) {
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();  // so that errors of the disk are told in the project's own way
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->Write();
  const vtkUnsignedCharArray* const bytes = writer->GetResult();
  OutputFile file(path);
  file.write({reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0)),
              static_cast<std::size_t>(bytes->GetNumberOfValues())});
  file.commit();
}

}  // namespace fingerpad
