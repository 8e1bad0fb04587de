#ifndef BlendModeAdvice_h
#define BlendModeAdvice_h

/// Which mapper to use for a blend mode (vtkConvexCellMapper::BlendModes), as the end of a
/// sentence.
const char* BlendModeAdvice(int mode);

#endif
