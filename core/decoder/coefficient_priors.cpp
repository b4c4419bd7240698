// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "coefficient_priors.h"

#include <array>

namespace mocapress::decoder {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "/>?BDGKRFGHHJKOUHIJKLNPTGKJJMNQVJMMMNORWKNNOPPSWOQOPRSTYNVTTUTW]1=?ADGKSHHIIKLOUJJKLMNQTIJ"
    "KLMOQVLNNNOPRWNPPPQRTXPTRRSTVZXaUZXZX_5>@BEHMUIIJJLMOVKKKLMNQUKLLMMORWNOPOOQSWQQQQRSTXUUTT"
    "TUW[ZSWZ^Z[a;?BDGJNXHHJJLMPVLLLMNORVLLMNNPSWPOPOQQTXSTSSRSUYYVVVWVX]gX[_[]]bBCEGILQ[IIJKMN"
    "QWLLLMNPSXNMNNOPSXRPPQQSUYURSTTTVZ[XVVWWY^h[m]_]^dHDIKMPUbIKJMMPSXNMLMNQUYOLNOPQUZSPRQRSV["
    "XSSTTTW[]YXWXXZ_h^b]^__eOFLNPTYgIKLMNQSXNMMNORV[PMOPQSVZTRPQSSW]YTRTUUX^_VVWWX[_je]]]]_gWJ"
    "OSTW]hIJKOQSW_NKLNRTX^TQPRRTX_WSSRSUX_[UTUVVY``VYY[Z[`l`Vmaaag)79;>AGSCDDEGHLSEFGHIKNTFHGH"
    "IKOVHIKKLNQWNOOOOQSY[WQRUVX^l `VbYbg0:;>?BGNECDDEFJSGIGIIJMRFFEGGILQJJKGJLNSKLJNLKNU;HGJGJ"
    "KQ        2<>?BEHMFFGEHHKQHHGIIKNPGIGHHJMRLKJJKKNQJNKLLLPTLUOJNONT        5?@BDFJOGGHHIILS"
    "HJHJJKMQHIHHJKMTJKJJKLNTLNMMMMOUOTMOOPQV@  J  PQ7@BDFHLQIHIIKKMTJJKKLMORIJKKLMOSLMMLMNPULM"
    "MMNOPURSOPOPRXT  R TQV:ACEGJNSIIJJLMOTKKKLNOPSKKLMNOQUMOONOPRUNOOPPQRVORPQRRSWRaW_]VWY=CEG"
    "ILPUIJJKMNQVLLLMNPRULMMNOPRVOPPPQRSVRRQRRSTWTTSTTTVYSQUUXYY]DDGIKNRZIJKLMORXMMLMNPSWNMNOOQ"
    "TXRPQQQSUXUSTTTTVYZWVVWWX[gX][][]`OGKMORWcKLMNORTZNNNNPRVZQNPQQSV[URRRSTW[YTUUVVX]_VXXYYZ_"
    "kb^b_^_d_     ef     Q cc   QL^ic   OYU_c  WcQZa`  OUY^ac`fX][`cm R[Zdbi6?DK17? 59>A7:@F9<"
    "CH;?FL?DPXCGNSGKQXNSZc0<@I.49 26=@57<B89?G;<AI>>DM@AEPBCHUEHKTADEG>AB ?BCB@ACDABDGCDFIDEIO"
    "FGKPGIMSJMRXBHIKBDF CEE<CDFHDEGIFGHKGHKQIJLPJKNTMNSZKJORFIF GAK FGHLHJKMIJLMJKNSLMNRMNPTOP"
    "TZ  TQE   I   I@GUJLMRLMNOMNQWNOQSPQRVQRUZ            I   L   MMOTPRX_QRTURSTWTUW[        "
    "        H   K   P^fjRUVXUUWXWXY^                    Q   MqlmUVXbUWY]Y[^`                  "
    "       s|uT Q VUYeZ`cg&%1468;=@DGJLOQTVXZ[[Xadoje     )'0357:=?BFILNQSVXZ]^aaccad     ,)22"
    "57:<?BEHKNQSVXZ]`aceikxl    1*3369:<?BEHKNQTVXZ]_bdgiknnc   <,878:<>@CEHJNQTVX[^`adfhknrm "
    "  G5::9=>@BDFHKNQTWY[_abegjlnvr   SAD?A?@DCEGIKNRUWZ]_acfijlnqt   e   FTLLJJKMNQSVY[^`bcgj"
    "loorq   LJJKMORXLJJKMOSYKJJKMOSZNIJKMPT]QJJLNQU_SJLMORVaVKNOPSWcWIOQRVZeFGFGHJNTFEFGGJNTFD"
    "EFGJNVQEFGHJOXSGIHILPZUHKJKMR]VIMLMOS_XJOOOQUaBEDEFFIPEFDDDFIQIAFDEFJRSFIFGGKTUBJIIILVUBKJ"
    "JKNXVCMLLLOZXJNONOQ]A=<<ADEMG>3CDBEMG<GECDFOTEJGFFGQU<KHHHISU?JIKJKUU MJLLLWWIMMNNOY    A?"
    "CK@  ;>CDLH D9GDDNT KLIFGPT MMIKHRU RLKKJTT PKKNLUV LOMNNW      DM     =CJ    OGFLS FMHJHN"
    "S NMHLIPS RNMLJRT QNNMLST RONLNU      @M      =J      CKR  O IFMQ RPQNGOQ MOMMJPR NPGNKRS "
    "MOQOMS       D       I       IO  OOOFKO HOJNGLO JOOOHNO LLRLLOQ JMMLLPLLMOQTYdLLNOQSV_MMNP"
    "QTW^MMNPRTW]NNOQSUX^PPQRSUY_SQSTUWZ`ZSUWXZ_fIHIJLOT`IHIJKNRZJIIJLORYJIIKMOSXKJKLMPSYMKLMNP"
    "TYPNNOPRU[YPQRSVYaMFGHILQ[JEFGHJMVJFGGHJNUJGGHIJNTKHGHIKOTLHHIJLPUPJJKLMQWXNOOPRU]RGFGHIMX"
    "O>@BEGIUM?EDEEJTLDCDEGIPLDEFFGJPMCFGGHKQOFGHHILSWKLMMNPXTHHHIILUR IGFIGTPJDCDEGRM8AEDCGNMG"
    "F>DFGMM=EFFFHNOEEFFHIOVIKJKLMUTGLGIJJST   >DISP   =BJRN  E:DDNL?EH@BEJM ECACFKNABFDFGLTGLJ"
    "IJKSS IIIJIQQ     KRR     JTL     EOL    ?HIK  @@CBIM @EDEEKRIKJIIIQQ  QNJKOQ      PP     "
    "FQM      OG     =KI     =HJ    F?IP IKGIHNOHIQIHILJIIMKJJMKKKNLLLPMLLRPMMUXOOZhc`gRFFQB?@F"
    "EEDHDEEHFEFIGHGKJIJNQJKRXLMWdUWbYDGSC?DFA>>DA?@ECBCGCFFIIGGKQJJOXKMUaNZ^Y=BS   I   D> =CE;"
    ">ECACGGDEJQGHMWKLS] JZX  S   :   G   C   DO =GGE?IODILVLLR[ HWW  S           J   F   DR  G"
    "M FLTIMQY  UU  R               J   IM  FK  JSJNPV  RQ  P                   >   AH  HPOGNR "
    " OGLKJIJTOS[BIJJIIKLMQDGGIIJLMOSIHJJKKMMOSONONMMOOPSS POPPRQRU_  LUQWTUW     RaWWZ     _jW"
    "Y^      qPYdDAEFFFUKOY@CDEEEEGINBGFFEEHHKPD?CEFFIHKPKFGHHHJIKPR JOKJNKMQ_   PNUOPR     R_Q"
    "SU     TdTVY      nVV`GBCABDVILW 8DCBCCCHM?B?IEDJFHN< CCDEJEHNFGE>CFKEHNN @DBGNGIN_   LMTJ"
    "KO     P[NNR      aQRU      hXS]G J?D>VFIU  J<AA@?EK   D7AIEGL   >FFLEFL    FCNCDL    =APD"
    "DL_   JHSFFL     _XJIN      ]NOQ      dXPX      UGGT        IE     @O7AK    @:LBBL     GNF"
    "GK     GODDKJ    IQFDK     TUGGL      XNKN      `OUV      TCIS         F      Q @K      O>"
    "=K      L8BJ      NIGK      OFFJ      Q>DK      TMGL      [ RS      S AR                M "
    " J      O  I      O  K      K=:I      MLCJ      N FJ      PL@J      X QQ      P  O        "
    "        L  G      M  G      L  J      N  J      K  H      K  I      M  I      R KNQJHGHHGH"
    "IIJKMOQTVX[^`cegjmqsq   VB?E@DBCCCDEGIKNQSVXZ^`ceiloy   ZBG88D@CBBCDFGGIKNQTVY[_adhml   Y "
    "   ?>FIFEGIJHGHILNQTVY]`chn   W       RLLKNPMKIHIJMPRUX[_de   V       Q RHNQNNLKIHILNQSWZ`"
    "c   U         VTNQMOOMLJILKMOSVZa   R         L MQLLMNMLKOKLLNPQS                         "
    "          HDHDFEFFGGHHIJLMMNNOOOOOOPON    NF?HFEDFGFGFGHIJLMNNNNOOONPP    M    Q>GHHGHHHHH"
    "JKLMNOOOOPOQ    O        OKKKKIIIHJKLMNOOOPNd   O          EMLIKIHHIJKLMNOOOP   N         "
    "  ILKKJJJIIJJKMMNOK   L         O LKLKLJJKIKJJKKLMM           KKLLMMMMKKLLMMMMJKKLMMMMIJKL"
    "LMMMIJKKLLMMLJKKKLLLMJJJKKLL                                                              "
    "                  K       HJ      HIKK    IHJKL   JJKKKMO KKLLLMN LLMMMMNNMMMMMNNNKNMMMNOO"
    "LLMNLNNOL       HJ      HIJJ    HHHJK   HHHHILM JJJIJKM KKKKKLMNLLLLMMMNLLMLMNNNMOMKLNNOM "
    "      FI      HFJI    GIIKK   HHHGJKL HHIHIJL IIIJIJKNKLKKKLLNLLMMLMMNLMNLMMNOM       DJ  "
    "    =FJH    HHHJK   @JGHJKK DFEIHIK IJGGIHJMJIIJIIJMKMIKKKKMNOMMMLMNL       @H        LM  "
    "    @JI   G IKHJL > GGHIJ KDHFGGJKGJKHGIHKLIIIIIIKIIOLIKKML                 K       _MK   "
    "    LJF    HJCJ     CEJJ   GHFHKIJEKKGHKG@JHJKJLL                 J        LO       OJI   "
    "   KK      HHJ     @FJ     CDJ  >JJIIL                                IJJLNOO KMLLNOP LMJK"
    "MOO MHMMNOP L ILMNO L QMMNOTL NLLMOPL  NMMO=M  LLLNHN  NMMN=L  LMLMLL LMMMNNOPNOOMOPOONMOO"
    "MNNMPRPPQPOPPOPNNOMOQOMMKONLMMKQSQQRQPRPOPNOPMPQNMMJNNKMMKQSQQSQPSPOOONPMOQNMMJNNLMMKQSRQS"
    "QPSPONPNONPQONMKNMLMMLPRQPRQPRQOMRNONQPPONMNNNONMPQPOPPPPPOLRNNNQPQPOPNNNOOOPOOOOPPPPOMQOO"
    "NOQQOPQNPOQOQOONMLNOOOOOOPNOMNNMQPPPMNPRLONKQNNPNLQQQSNNTSRNMPPSMKJKPPQNMNPQ6KNQTX[chx5EJL"
    "PTXal|8DFKNRYbj|<EGKNSVco|?HJJOTTel|AMINPTUdp|A LKNSUgm|H ?JLPXhp|6CFGIJERW DMQQSUXal|6FHI"
    "KNMYb|AGJLNPL_YbKNRVVZajr|CLNPRW[fo|                    <FFNLR]^c|                        "
    "                          : BDFLQZat5BFHNTZerq6KPTYahwsp                                  "
    "      :  @EKPWjx7 @EHMS^gz6AGHNSXblv3ELOSYbrww                              ?   INWbjz;  G"
    "FKS[d|8 @EJOU^e|7DGKOT_iux4DGLQWb{z|                    C    NT`gq@   LPWav|;  EHMS]h|9 AH"
    "IQWaw|;DGJPW`oo|8EHMRVany|                    B    SS]atB   JPXdo|=  EJOT`e|= LEPT[nv|=GGK"
    "RYbnv|=HJNTZcuu|                    C    QT[gpA   MPWal|@  KOTZgo|> HLOV[gv|?JIOSakss|BTNS"
    "Xilkmu                    D    NU]awA   IPWdj|A  LPT_jv|@ MJR^dst|: GMS[kklv              "
    "                L    KXep{I   KNYgm|E  KNYcsu|B ?EP_kklw                    TRLK#         "
    "                  H>1                             W[ZYXWUTSRPMJJJ<                TYXWVUTS"
    "RPOMKJMSRM              urpkgba_]YVUTRNJG?              ceb`][YXWVTSSRPMJE              WX"
    "_O(           TRJI&                                                                       "
    "                                                                                          "
    "                                                                          H*              "
    "H@1                                                                                       "
    "                                                                                          "
    "                                                            X]ZYXVUTSRPMLKJ<GNPQQOI       "
    "  TMNNOPSF        YWMNLLRbJ       ^[VNNNJO`M      c`[VNNLIL       kfa]VMKHJ       rmfc]VKI"
    "GL      nrnfc^VJIJL     pxxjed_VIHJH    wwwwlgf`XIGH    wwwwwkfhaWHC?   uuuuumhdf`VF>   qq"
    "qqqqqfdf^UD<  jjjjjjjjbbj^R@                  UYXWVUTSQPONKKOPHMOONLKM        RQPOOLJF    "
    "    YWQPPOOKK       _]VPOPMRLI      c`[VQOOMRKF     ee`]VPNNLOMH    gdg`ZVOMMHL     ijge`]"
    "VMLPLPF   nnhgg`]VMMPMMH  ollijg_[UMJMN?  uufufjf`^VKIOJ  rrrjrdff`[YHHT  nnnnnnfnn`]WB@  "
    "gggggggggggWSH                  urpkgba_]YVUTRNI                                          "
    "                                                                                          "
    "                                                                                          "
    "                  ceb`][YXWVTSSRPL                                                        "
    "                                                                                          "
    "                                                                                          "
    "    RVRO$           SMKE3           WTH?7           ^UE.            UNI3            LWF6  "
    "          tLG9            ]Q0             YH8             ll3             i6              "
    "[V(             tNF9                                                            G>3       "
    "      L@6             1               3               F2                                  "
    "                                                                                          "
    "                                                                                  PVYYZYXU"
    "UTQOKC  RUSTRQRRQPPK    VVVSSQOPPORH    WXVVTRPONQLK    Y[XVUTRONOQL=   Y_YWVTRQOLMNH   [^"
    "]XWUSQROKII   ]b^[XWURQQMJGT  ^c`^ZXVTQQNHHJ  _fb_^YWUTONKH>  bkd`]]XWVSNJFO  jlgd`]ZXVVRL"
    "ID  xxjfc_Z[XVSOKI? ssshe`^W[XVRLG  rrrrrc]ZWWUUSQL>TYYXVUTSRQONKKNPILNNMMOL        QONLNL"
    "LJ        VSPOOLIE        ZWTONMKI>       _[WSONKKI@      c`ZWRONKKC      fd_ZWROMMKF     "
    "jfc^YVRNMLIJ    hicc^YVQLMGF    oiecb^ZXPLLGO   xlidcb^XXOMII   umiccca[WUOJA   qqif``eb^W"
    "TPC   kkk``c_b]^[XO;  dddd[dddZZccYL  wwwoc]ZXWTRQPNI                                     "
    "                            ddddddddPR@     jjjjjjjj^NRE    kkkkkkkkcXMMG   lllllllldZWMNF"
    "  mmmmmmmm^YUXNP= hpppphphdWSVWLSHqeehqcec``WRVVJNpphappd_[^_VQUTGnnnccnnc_[^aTPNKnnnnafnn"
    "c]]a_SI<qqqqqiabic_]XWSIefa`][YXWWUSSSQLfWTZYI          VZSTM           WXXSSRM         X_"
    "b[SQOO        ZckXYRQQT?      ^beaWWSPPP@     _^]]]VURPNQ     dd]^ZZUUSOLO    oga]cZYTRQML"
    "    nnnf_`^^UOOSO   nnncf_]`ZVKNO   nnnnaf]`YWSIN   llllldl^cXYSHJ  iiiiiiiiii]`VF  mmmmmm"
    "mmmmmmaYOK                ZM0             sLI9            IYK6            VQL3            "
    "aTG0            VVI;<           TJHD9           RVRO$           RRLE5           YQEG9     "
    "      YUC6            UK2             RU0             iO9             _S<9                "
    "                                                            F2              3             "
    "  9               MC9             G>3             L>9             2                       "
    "                                                                                        PV"
    "XYZYWUTTQOKC  RVTTRRRQQNNK    UWWTTQQQPPMG    XYWWUSPPPPNJG   Z[XVVUSPPPOMK@  [_YXVTSSPNNL"
    "H   ^^]XXVSRRPMMF   _b^[XWURQRNLKK  bd`]ZXVTQQOHHJ  ffb_]YWVTONLG?  ikd`][XVVSNJGO  {lgda["
    "ZXVWRLIE  wwjed_[[YVTOKH@ rrrfd`^X[XWRKI  qqqqqc`[WVUUURL>                MSTUTTTSRPONIG  "
    "QSSSRQRPNQOMH   TVSSSRPONLLG    VXVSRRROPMLK@   YZXUSRQPNMOIG   ]]YXTSQPPNJIH   ``]YWTRROO"
    "MK9   bb_[XVSQQONKJ>  eea^[XUSQPNMLI  jjc_]ZXURPOLKG  mkeb_]YWTPNNDH  nnid^^[YWSOMK:  kvig"
    "c[]XXYSPKJ? jjrjd_X]UVVSPNL rggrrc_XVSPQVSWRwwwoc]ZXWTRQPNI                               "
    "                                  ddddddddPR@     jjjjjjjj^NRE    kkkkkkkkcXMMG   llllllll"
    "dZWMNF  mmmmmmmm^YUXNP= hpppphphdWSVWLSHqeehqcec``WRVVJNpphappd_[^_VQUTGnnnccnnc_[^aTPNKnn"
    "nnafnnc]]a_SI<qqqqqiabic_]XWSIhda_[YXVUTSQPRRMXZYi]]Y_ZYQPQ   YVTTWQaW`Q      ^]WYVXUffTKO"
    "    Zc]]ZVVW^ZSKH   bq`YZXUUWWSTK@  gecZYZVVUXSSQK  bgj`[YZWWUXTSRK@ggbg^[XXYXSYVQRIejjec]"
    "YZVVVS[TMGqiieec^YWXSVTYNGbphbdg_[[WWSYRYKcnnfcff^XZXRTXSPjjjj_jj_^TWWON Rfffff^^fY[QXaR@ "
    "hhhhhh`Y_^fWTMJ  RIGH                            I1                              OMMMMMMLM"
    "MKJIJK                 OMMMMMLLLLKKIKJ                   IONONPPNMMONMHH               SNN"
    "NNNMMMNMKNNKGF              ";

constexpr std::array<std::int16_t, 200> kWeights = {
    -703, 697, 1129, 307, 307, 307, 307, 307,
    -192, 635, 129, 944, 18, 307, 307, 307,
    315, 277, 45, 503, 4, 307, 307, 307,
    434, 107, 185, 355, -102, 307, 307, 307,
    272, 224, 116, 616, 136, 307, 307, 307,
    320, 281, 68, 766, -47, 307, 307, 307,
    287, 8, -68, 727, -67, 307, 307, 307,
    129, -2, 55, 756, 41, 307, 307, 307,
    42, 202, 513, 580, -248, 307, 307, 307,
    60, 154, -7, 242, 794, -108, 307, 307,
    85, 149, -37, 359, 834, -233, 307, 307,
    -27, 233, 5, 351, 898, -186, 307, 307,
    117, 446, 112, 307, 1056, -305, 307, 307,
    159, 137, 68, 115, 1140, -322, 307, 307,
    274, -36, -93, -31, 1015, -78, 307, 307,
    469, -62, -385, 206, 623, -23, 307, 307,
    513, 5, -141, 284, 347, 276, 307, 307,
    845, -62, 387, 307, 307, 307, 307, 307,
    705, 1191, 685, 587, 307, 307, 307, 307,
    -630, 811, 335, 714, 307, 307, 307, 307,
    -18, 165, 599, 647, 307, 307, 307, 307,
    -402, 903, 159, 501, 307, 307, 307, 307,
    -1042, 803, 1317, 455, 307, 307, 307, 307,
    110, 77, 435, 435, 307, 307, 307, 307,
    -91, -126, 1094, 842, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress::decoder
