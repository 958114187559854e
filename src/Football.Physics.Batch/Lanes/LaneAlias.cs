// Without interfaces that have static members (C# 11, .NET 7) what is written for registers of any width is compiled for one float: the
// type parameter F of .NET is this type there.
#if !NET8_0_OR_GREATER
global using F = FootballPhysics.Batch.Lanes1;
#endif
