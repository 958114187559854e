// The library in a browser or in Node. Package/index.js calls the methods of Engine. The numbers of a frame are in memory that both sides read.
using System.Runtime.Versioning;

[assembly: SupportedOSPlatform("browser")]

internal static class Program
{
    private static void Main()
    {
    }
}
