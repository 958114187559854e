using System.Globalization;

// What a program is without the library.
Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"landed after {Environment.TickCount64:F2} s"));
