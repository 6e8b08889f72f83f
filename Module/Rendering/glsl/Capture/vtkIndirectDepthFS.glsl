//VTK::System::Dec
// Draws depth only, which OpenGL writes.
void main()
{
}
