// Runtimes without static interface members (C# 11, .NET 7) cannot compile the generic code for registers of any width. There, the type
// parameter F becomes an alias of the one-float type.
#if !NET8_0_OR_GREATER
global using F = FootballPhysics.Batch.Lanes1;
#endif
