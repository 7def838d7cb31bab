#include "view/png_vtk.hpp"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
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

namespace {

void write_encoded(vtkPNGWriter* writer, const std::string& path) {
  writer->WriteToMemoryOn();  // so that errors of the disk are told in the project's own way
  writer->Write();
  const vtkUnsignedCharArray* const bytes = writer->GetResult();
  OutputFile file(path);
  file.write({reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0)),
              static_cast<std::size_t>(bytes->GetNumberOfValues())});
  file.commit();
}

}  // namespace

void write_png(vtkRenderWindow* window, const std::string& path) {
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  write_encoded(writer, path);
}

void write_png(const Pixels& picture, const std::string& path) {
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  constexpr int not_its_own = 1;  // the pixels stay where they are: they can be a third of a gigabyte
  rgb->SetArray(const_cast<unsigned char*>(picture.rgb.data()),  // only read
                static_cast<vtkIdType>(picture.rgb.size()), not_its_own);
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->GetPointData()->SetScalars(rgb);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  write_encoded(writer, path);
}

}  // namespace fingerpad
