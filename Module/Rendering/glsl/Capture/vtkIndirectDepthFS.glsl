//VTK::System::Dec
// Depth comes by itself.
void main()
{
}
