using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace FootballPhysics.Tool.Commands;

/// <summary>Identifies the file behind a path. All hard and symbolic links to a file have the same identity, whatever the names of the folders.</summary>
internal static class FileIdentity
{
    private const int AtCurrentFolder = -100;
    private const uint InodeNumber = 0x100;

    /// <summary>
    /// Returns the identity of a file. Returns the full path if the file does not exist or the system gives no identity, and null if the path is
    /// invalid. An invalid path is reported when the file is opened.
    /// </summary>
    public static string? Of(string path)
    {
        try
        {
            string full = Path.GetFullPath(path);
            return File.Exists(full) ? Number(full) ?? File.ResolveLinkTarget(full, returnFinalTarget: true)?.FullName ?? full : full;
        }
        catch (Exception e) when (OutputFile.IsFileFault(e))
        {
            return null;
        }
    }

    private static string? Number(string path)
    {
        try
        {
            return OperatingSystem.IsLinux() ? OfLinux(path) : OperatingSystem.IsMacOS() ? OfMacOS(path) : OperatingSystem.IsWindows() ? OfWindows(path) : null;
        }
        catch (Exception e) when (e is EntryPointNotFoundException or DllNotFoundException || OutputFile.IsFileFault(e))
        {
            return null;
        }
    }

    private static string? OfLinux(string path)
    {
        // struct statx, the same on every processor: stx_ino is at byte 32, stx_dev_major and stx_dev_minor are at 136 and 140.
        byte[] buffer = new byte[256];
        return Statx(AtCurrentFolder, path, 0, InodeNumber, buffer) != 0 ? null
            : Text(BinaryPrimitives.ReadUInt64LittleEndian(buffer.AsSpan(136)), BinaryPrimitives.ReadUInt64LittleEndian(buffer.AsSpan(32)));
    }

    private static string? OfMacOS(string path)
    {
        // struct stat with 64-bit inodes: st_dev is at byte 0, st_ino at 8.
        byte[] buffer = new byte[256];
        int fault = RuntimeInformation.ProcessArchitecture == Architecture.X64 ? Stat64(path, buffer) : Stat(path, buffer);
        return fault != 0 ? null : Text(BinaryPrimitives.ReadUInt32LittleEndian(buffer), BinaryPrimitives.ReadUInt64LittleEndian(buffer.AsSpan(8)));
    }

    private static string? OfWindows(string path)
    {
        // BY_HANDLE_FILE_INFORMATION: the volume is at byte 28, the index at 44 and 48.
        byte[] buffer = new byte[52];
        using SafeFileHandle file = File.OpenHandle(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        return !InformationOf(file, buffer) ? null : Text(BinaryPrimitives.ReadUInt32LittleEndian(buffer.AsSpan(28)), BinaryPrimitives.ReadUInt64LittleEndian(buffer.AsSpan(44)));
    }

    private static string Text(ulong device, ulong file) => string.Create(CultureInfo.InvariantCulture, $"{device:x}:{file:x}");

    [DllImport("libc", EntryPoint = "statx")]
    private static extern int Statx(int folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, byte[] buffer);

    [DllImport("libc", EntryPoint = "stat")]
    private static extern int Stat([MarshalAs(UnmanagedType.LPUTF8Str)] string path, byte[] buffer);

    [DllImport("libc", EntryPoint = "stat$INODE64")]
    private static extern int Stat64([MarshalAs(UnmanagedType.LPUTF8Str)] string path, byte[] buffer);

    [DllImport("kernel32", EntryPoint = "GetFileInformationByHandle")]
    [return: MarshalAs(UnmanagedType.Bool)]
    private static extern bool InformationOf(SafeFileHandle file, byte[] buffer);
}
