using System.Runtime.InteropServices;
using System.Text;

namespace FootballPhysics.Native.Tests;

/// <summary>Creates scenes through the C interface, and reads its last error.</summary>
internal static unsafe class SceneCalls
{
    private static readonly delegate* unmanaged<byte*, long, NativeScene**, NativeStatus> s_create = &Exports.SceneCreate;
    private static readonly delegate* unmanaged<byte*> s_error = &Exports.LastError;

    /// <summary>Returns the message of the last error of this thread.</summary>
    public static string Error() => Marshal.PtrToStringUTF8((nint)s_error())!;

    /// <summary>Creates a scene from JSON. The caller frees it.</summary>
    public static NativeScene* Scene(string json)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        NativeScene* scene;
        fixed (byte* at = text)
        {
            Assert.True(s_create(at, text.Length, &scene) == NativeStatus.Ok, Error());
        }

        return scene;
    }
}
